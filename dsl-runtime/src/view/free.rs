//! `OwnFree`: a path that the loop writes at indices which contain its variables, in any places.

use core::marker::PhantomData;

use super::Site;
use crate::axes::{Axes, MAX_AXES};
use crate::field::Handle;
use crate::index::{Integer, within};
use crate::launch::{Cell, Space};
use crate::layout::Layout;
use crate::record::{Path, Record};

/// The `N`th loop variable stands in this place of an index.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Var<const N: usize>;

/// Any integer stands in this place of an index.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Free<T>(pub T);

/// One place of an index.
#[doc(hidden)]
pub trait Place: Copy {
    /// The loop variable that stands here, as a bit.
    const VARIABLE: u32;
    /// The coordinate here.
    fn coordinate<S: Space>(self, cell: &Cell<'_, S>) -> i64;
}
impl<const N: usize> Place for Var<N> {
    const VARIABLE: u32 = 1 << N;
    #[inline(always)]
    fn coordinate<S: Space>(self, cell: &Cell<'_, S>) -> i64 {
        cell.at()[N]
    }
}
impl<T: Integer> Place for Free<T> {
    const VARIABLE: u32 = 0;
    #[inline(always)]
    fn coordinate<S: Space>(self, _: &Cell<'_, S>) -> i64 {
        self.0.wide()
    }
}

/// All places of an index.
#[doc(hidden)]
pub trait Places: Copy {
    /// How many.
    const COUNT: usize;
    /// The loop variables that stand in them, as bits.
    const VARIABLES: u32;
    /// Whether the index must be checked against the shape. Only one that was promised to lie within needs no check.
    const CHECKED: bool = true;
    /// The coordinates.
    fn coordinates<S: Space>(self, cell: &Cell<'_, S>) -> [i64; MAX_AXES];
}
macro_rules! places {
    ($($count:literal: $($place:ident $n:tt)+;)*) => {$(
        impl<$($place: Place),+> Places for ($($place,)+) {
            const COUNT: usize = $count;
            const VARIABLES: u32 = 0 $(| $place::VARIABLE)+;
            #[inline(always)]
            fn coordinates<S: Space>(self, cell: &Cell<'_, S>) -> [i64; MAX_AXES] {
                let mut at = [0; MAX_AXES];
                $(at[$n] = self.$n.coordinate(cell);)+
                at
            }
        }
    )*};
}
places!(1: A 0; 2: A 0 B 1; 3: A 0 B 1 C 2; 4: A 0 B 1 C 2 D 3;);

/// Reads and writes a path at indices in which every loop variable stands alone in a place, so that no two elements of
/// the loop share one. All indices of a path have the variables in the same places.
#[doc(hidden)]
pub struct OwnFree<'a, R, L, X, P> {
    handle: Handle<'a, R, L, X>,
    site: &'static Site,
    /// Neither `Send` nor `Sync`: elements belong to the thread that got the cell.
    path: PhantomData<(P, *mut ())>,
}

impl<R, L, X, P> core::fmt::Debug for OwnFree<'_, R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "OwnFree of `{}`", self.site.field)
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> OwnFree<'a, R, L, X, P> {
    #[inline(always)]
    pub(crate) fn new(handle: Handle<'a, R, L, X>, site: &'static Site) -> Self {
        Self { handle, site, path: PhantomData }
    }

    #[inline(always)]
    #[track_caller]
    fn locate<S: Space, A: Places>(&self, cell: &Cell<'_, S>, places: A) -> [u32; MAX_AXES] {
        const {
            assert!(A::COUNT == X::RANK, "an index has as many places as the field has axes");
            assert!(A::VARIABLES == (1 << S::RANK) - 1, "every loop variable stands in a place of an own index");
        }
        let at = places.coordinates(cell);
        if !A::CHECKED {
            return at.map(
                #[inline(always)]
                |c| c as u32,
            );
        }
        let Some(at) = within::<X>(at, &self.handle.geometry.shape) else {
            self.site.out_of_range(&at[..X::RANK], &self.handle.geometry.shape[..X::RANK])
        };
        at
    }

    /// The value there.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get<S: Space>(&self, cell: &Cell<'_, S>, places: impl Places) -> P::Value {
        let at = self.locate(cell, places);
        // SAFETY: within the shape; the cell's loop variables make the element this iteration's own.
        unsafe { self.handle.read::<P>(at) }
    }

    /// Puts a value there.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn set<S: Space>(&self, cell: &Cell<'_, S>, places: impl Places, value: P::Value) {
        let at = self.locate(cell, places);
        // SAFETY: within the shape; the cell's loop variables make the element this iteration's own.
        unsafe { self.handle.write::<P>(at, value) }
    }
}
