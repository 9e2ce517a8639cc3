//! Indices that a caller has promised to lie within their fields: in kernels that are `unchecked`. With debug assertions they are
//! checked all the same.

use crate::axes::{Axes, MAX_AXES};
use crate::element::Sealed;
use crate::index::IntoIndex;
use crate::launch::{Cell, Space};
use crate::view::Places;

/// Whether indices are checked in spite of the promise.
const CHECKED: bool = cfg!(debug_assertions);

/// The promise of an unchecked kernel's caller. Whoever has one may leave index checks out.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Unchecked(());

impl Unchecked {
    /// The promise.
    ///
    /// # Safety
    /// Every index that is made with it, and every box of indices that it is asked about, lies within the shape of its field.
    #[inline(always)]
    pub const unsafe fn promised() -> Self {
        Self(())
    }

    /// An index that need not be checked.
    #[inline(always)]
    pub fn index<T>(self, index: T) -> Promised<T> {
        Promised(index)
    }

    /// Whether the boxes of a loop's rows lie within their fields, which `check` finds out.
    #[inline(always)]
    pub fn fits(self, check: impl FnOnce() -> bool) -> bool {
        !CHECKED || check()
    }
}

/// An index that was promised to lie within its field's shape: nothing but an [`Unchecked`] makes it.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Promised<T>(T);

impl<T> Sealed for Promised<T> {}
impl<X: Axes, T: IntoIndex<X>> IntoIndex<X> for Promised<T> {
    const CHECKED: bool = CHECKED;
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        self.0.coordinates()
    }
}
impl<T: Places> Places for Promised<T> {
    const COUNT: usize = T::COUNT;
    const VARIABLES: u32 = T::VARIABLES;
    const CHECKED: bool = CHECKED;
    #[inline(always)]
    fn coordinates<S: Space>(self, cell: &Cell<'_, S>) -> [i64; MAX_AXES] {
        self.0.coordinates(cell)
    }
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> [(i64, i64); MAX_AXES] {
        self.0.extremes(first, end)
    }
    #[inline(always)]
    fn holds(self) -> bool {
        self.0.holds()
    }
}
