//! `Beside`: a path that the loop writes at one colour of a checkerboard, read at the other.

use core::marker::PhantomData;

use super::Site;
use super::lane::Lane;
use crate::axes::{Axes, MAX_AXES, padded, per_axis};
use crate::field::Handle;
use crate::index::{within, wrapped};
use crate::launch::{Cell, TwoColours};
use crate::layout::{Geometry, Layout};
use crate::probe::Index;
use crate::record::{Path, Record};

/// Reads a path at the elements of a loop over one colour of a checkerboard, moved by an offset with an odd sum.
///
/// The loop writes the path at its own elements alone, whose coordinates' sums have one parity. What this view reads has
/// the other parity, or is the iteration's own element: nobody else writes it during the launch. Values are copied byte
/// by byte from their addresses, and elements share no byte; so threads that write neighbours do not matter.
#[doc(hidden)]
pub struct Beside<'a, R, L, X, P, S> {
    lane: Lane<'a, R, L, X, P>,
    offset: [i64; MAX_AXES],
    /// Neither `Send` nor `Sync`: what may be read is seen from the cells of one thread.
    space: PhantomData<(S, *mut ())>,
}

impl<R, L, X, P, S> core::fmt::Debug for Beside<'_, R, L, X, P, S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Beside of {:?}", self.lane)
    }
}

/// Whether an offset leads to the other colour.
fn is_odd(offset: &[i64]) -> bool {
    offset.iter().fold(0, |sum, o| sum ^ o) & 1 == 1
}

/// Panics where an index that is taken modulo the extents and moved by `offset` could keep its colour: an extent along
/// which it moves is odd.
#[track_caller]
pub(super) fn assert_even(shape: &[u32; MAX_AXES], offset: &[i64], site: &'static Site) {
    for (axis, (offset, extent)) in offset.iter().zip(shape).enumerate() {
        assert!(
            *offset == 0 || extent.is_multiple_of(2),
            "kernel `{}`: `wrapped` reads the field `{}` under `checkerboard`, and its extent {extent} along axis {axis} is odd: \
             its first and its last element have one colour",
            site.kernel,
            site.field
        );
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>, S: TwoColours> Beside<'a, R, L, X, P, S> {
    #[inline(always)]
    #[track_caller]
    pub(crate) fn new<const N: usize>(handle: Handle<'a, R, L, X>, site: &'static Site, by: [i64; N]) -> Self {
        const {
            assert!(S::RANK == X::RANK, "an own index has as many places as the field has axes");
            assert!(N == X::RANK, "an offset has as many places as the field has axes");
        }
        assert!(is_odd(&by), "an offset with an even sum leads to the loop's own colour");
        Self { lane: Lane::new(handle, site), offset: padded(by), space: PhantomData }
    }

    #[inline(always)]
    fn geometry(&self) -> &Geometry {
        &self.lane.handle().geometry
    }

    /// The cell's coordinates, moved.
    #[inline(always)]
    fn moved(&self, cell: &Cell<'_, S>) -> [i64; MAX_AXES] {
        let at = cell.at();
        per_axis(
            #[inline(always)]
            |a| at[a].wrapping_add(self.offset[a]),
        )
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn outside(&self, at: [i64; MAX_AXES]) -> ! {
        self.lane.site().out_of_range::<X>(at, self.geometry())
    }

    /// The value at the offset.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, cell: &Cell<'_, S>) -> P::Value {
        let at = self.moved(cell);
        let Some(at) = within::<X>(at, self.geometry()) else { self.outside(at) };
        // SAFETY: within the shape, and of the other colour than the loop's, which alone is written.
        unsafe { self.lane.read(at, Index::Offset) }
    }

    /// The value at the offset, or the cell's own where that lies outside: what is nearest, for a step of one along an axis.
    ///
    /// # Panics
    /// Where the offset is no single step, or the cell itself lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn clamped(&self, cell: &Cell<'_, S>) -> P::Value {
        assert!(self.offset.iter().map(|o| o.unsigned_abs()).sum::<u64>() == 1, "a step of one along one axis");
        let (at, own) = (self.moved(cell), cell.at());
        let Some(at) = within::<X>(at, self.geometry()).or_else(|| within::<X>(own, self.geometry())) else {
            self.outside(own)
        };
        // SAFETY: within the shape; of the other colour, which nobody writes, or this iteration's own.
        unsafe { self.lane.read(at, Index::Offset) }
    }

    /// The value at the offset, modulo the extents.
    ///
    /// # Panics
    /// Where an extent along which the offset moves is odd, or the field has no element.
    #[inline(always)]
    #[track_caller]
    pub fn wrapped(&self, cell: &Cell<'_, S>) -> P::Value {
        // The launch has told the user; this is what the next lines rely on.
        assert_even(&self.geometry().shape, &self.offset[..X::RANK], self.lane.site());
        let at = self.cell_within(cell);
        let Some(at) = wrapped::<X>(at, self.geometry()) else { self.outside(at) };
        // SAFETY: within the shape; an even number of steps back keeps the colour, so that it is the other than the loop's.
        unsafe { self.lane.read(at, Index::Offset) }
    }

    /// The moved coordinates of a cell that lies within the shape along the axes that are not moved.
    #[inline(always)]
    #[track_caller]
    fn cell_within(&self, cell: &Cell<'_, S>) -> [i64; MAX_AXES] {
        let (at, moved) = (cell.at(), self.moved(cell));
        let (shape, origin) = (&self.geometry().shape, &self.geometry().origin);
        let place = |a: usize| at[a].wrapping_sub(i64::from(origin[a])) as u64;
        let beyond = |a: usize| self.offset[a] == 0 && place(a) >= u64::from(shape[a]);
        if (0..X::RANK).any(beyond) {
            self.outside(moved);
        }
        moved
    }

    /// The value at the offset, or `value` where that lies outside of the shape.
    #[inline(always)]
    pub fn or(&self, cell: &Cell<'_, S>, value: P::Value) -> P::Value {
        match within::<X>(self.moved(cell), self.geometry()) {
            // SAFETY: as in `get`.
            Some(at) => unsafe { self.lane.read(at, Index::Offset) },
            None => value,
        }
    }
}
