//! What a job may accumulate into: a field's memory or a copy of it, and which elements of it.

use core::cell::RefCell;
use core::fmt;

use super::Scattered;
use super::late::Late;
use crate::axes::{Axes, MAX_AXES, per_axis};
use crate::layout::Geometry;

/// A box of places within a field's shape: what a job may reach.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Window {
    first: [u32; MAX_AXES],
    extent: [u32; MAX_AXES],
}

impl Window {
    /// All elements.
    #[inline(always)]
    pub(crate) fn whole(geometry: &Geometry) -> Self {
        Self { first: [0; MAX_AXES], extent: geometry.shape }
    }

    /// Those elements whose logical coordinates lie in `low..end`.
    pub(crate) fn between(geometry: &Geometry, low: [i64; MAX_AXES], end: [i64; MAX_AXES]) -> Self {
        let place = |a: usize, at: i64| {
            at.saturating_sub(i64::from(geometry.origin[a])).clamp(0, i64::from(geometry.shape[a])) as u32
        };
        let first: [u32; MAX_AXES] = core::array::from_fn(|a| place(a, low[a]));
        Self { first, extent: core::array::from_fn(|a| place(a, end[a]).saturating_sub(first[a])) }
    }

    /// The first logical coordinate of the box along an axis, and the one after its last.
    #[inline(always)]
    pub(crate) fn span(&self, geometry: &Geometry, axis: usize) -> (i64, i64) {
        let start = i64::from(geometry.origin[axis]) + i64::from(self.first[axis]);
        (start, start + i64::from(self.extent[axis]))
    }

    /// The place of logical coordinates that lie in the box.
    #[inline(always)]
    pub(crate) fn within<X: Axes>(&self, at: [i64; MAX_AXES], geometry: &Geometry) -> Option<[u32; MAX_AXES]> {
        // What lies below becomes, as an unsigned number, larger than any extent.
        let beyond = per_axis(
            #[inline(always)]
            |a| at[a].wrapping_sub(i64::from(geometry.origin[a])).wrapping_sub(i64::from(self.first[a])),
        );
        crate::index::inside::<X>(beyond, &self.extent).map(
            #[inline(always)]
            |beyond| {
                per_axis(
                    #[inline(always)]
                    |a| if a < X::RANK { self.first[a] + beyond[a] } else { 0 },
                )
            },
        )
    }
}

/// What a job accumulates into for one field.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub(crate) struct Share<'t> {
    /// The field's memory, or that of a copy.
    pub(crate) root: *mut u8,
    /// The elements that the job has to itself.
    pub(crate) window: Window,
    /// Takes the updates of others, where the window is not the whole field.
    pub(crate) late: Option<&'t RefCell<Late>>,
}

impl Share<'_> {
    /// That of no field.
    pub(super) const NOTHING: Self = Self {
        root: core::ptr::null_mut(),
        window: Window { first: [0; MAX_AXES], extent: [0; MAX_AXES] },
        late: None,
    };

    /// All of a field, in its own memory or in that of a copy.
    pub(super) fn whole(target: &dyn Scattered, root: *mut u8) -> Self {
        Self { root, window: Window::whole(target.geometry()), late: None }
    }
}

impl fmt::Debug for Share<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Share({:?})", self.window)
    }
}
