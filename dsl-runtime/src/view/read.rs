//! `Read`: a path that the loop only reads, at any index.

use core::marker::PhantomData;

use super::{Based, Site};
use crate::axes::Axes;
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::record::{Path, Record};

/// Reads a path of a field at any index. Nothing in the loop writes it.
#[doc(hidden)]
pub struct Read<'a, R, L, X, P> {
    handle: Handle<'a, R, L, X>,
    site: &'static Site,
    path: PhantomData<P>,
}

impl<R, L, X, P> Clone for Read<'_, R, L, X, P> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P> Copy for Read<'_, R, L, X, P> {}
impl<R, L, X, P> core::fmt::Debug for Read<'_, R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Read of `{}`", self.site.field)
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> Read<'a, R, L, X, P> {
    #[inline(always)]
    pub(crate) fn new(handle: Handle<'a, R, L, X>, site: &'static Site) -> Self {
        Self { handle, site, path: PhantomData }
    }

    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> P::Value {
        let Some(at) = self.handle.locate(index) else {
            self.site.out_of_range(&index.coordinates()[..X::RANK], &self.handle.geometry.shape[..X::RANK])
        };
        // SAFETY: `at` lies within the shape, and the launch holds the field's borrow under which nothing writes this path.
        unsafe { self.handle.read::<P>(at) }
    }

    /// The value at `base + offset`, checked with the base where the offset lies in the base's box.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get_at(&self, base: &Based<X>, offset: impl IntoIndex<X>) -> P::Value {
        let Some(at) = base.within(&self.handle.geometry, offset.coordinates()) else {
            let at = base.plus(offset.coordinates());
            self.site.out_of_range(&at[..X::RANK], &self.handle.geometry.shape[..X::RANK])
        };
        // SAFETY: as in `get`.
        unsafe { self.handle.read::<P>(at) }
    }
}
