//! `OwnFree`: a path that the loop writes at indices which contain its variables, in any places.

use core::marker::PhantomData;

use super::Site;
use super::probed::note;
use crate::axes::{Axes, MAX_AXES};
use crate::field::Handle;
use crate::index::{Integer, within};
use crate::launch::{Cell, Space};
use crate::layout::{Geometry, Layout};
use crate::probe::{Access, Index};
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
    /// The lowest and the highest coordinate here of the elements from `first` to before `end`.
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> (i64, i64);
    /// Whether the coordinate lies between the extremes.
    #[inline(always)]
    fn holds(self) -> bool {
        true
    }
}
impl<const N: usize> Place for Var<N> {
    const VARIABLE: u32 = 1 << N;
    #[inline(always)]
    fn coordinate<S: Space>(self, cell: &Cell<'_, S>) -> i64 {
        cell.at()[N]
    }
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> (i64, i64) {
        (first[N], end[N] - 1)
    }
}
impl<T: Integer> Place for Free<T> {
    const VARIABLE: u32 = 0;
    #[inline(always)]
    fn coordinate<S: Space>(self, _: &Cell<'_, S>) -> i64 {
        self.0.wide()
    }
    fn extremes(self, _: &[i64; MAX_AXES], _: &[i64; MAX_AXES]) -> (i64, i64) {
        (self.0.wide(), self.0.wide())
    }
}

/// A multiple of the `N`th loop variable plus an offset stands in this place, and what an unrolled loop adds to it.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Linear<const N: usize> {
    factor: i32,
    offset: i64,
    /// What may be added.
    low: i32,
    high: i32,
    /// What is added.
    moved: i64,
}

impl<const N: usize> Linear<N> {
    /// `factor * variable + offset`, to which something from `low` to `high` is added.
    #[inline(always)]
    pub fn new(factor: i32, offset: i64, low: i32, high: i32) -> Self {
        Self { factor, offset, low, high, moved: 0 }
    }

    /// The same moved by so much.
    #[inline(always)]
    pub fn by(self, moved: i64) -> Self {
        Self { moved, ..self }
    }

    /// Factors and variables are below 2^31, and so is their product far from the ends of 64 bits.
    #[inline(always)]
    fn at(self, variable: i64) -> i64 {
        (i64::from(self.factor) * variable).saturating_add(self.offset)
    }
}

impl<const N: usize> Place for Linear<N> {
    const VARIABLE: u32 = 0;
    #[inline(always)]
    fn coordinate<S: Space>(self, cell: &Cell<'_, S>) -> i64 {
        self.at(cell.at()[N]).saturating_add(self.moved)
    }
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> (i64, i64) {
        let (a, b) = (self.at(first[N]), self.at(end[N] - 1));
        (a.min(b).saturating_add(self.low.into()), a.max(b).saturating_add(self.high.into()))
    }
    #[inline(always)]
    fn holds(self) -> bool {
        self.moved >= i64::from(self.low) && self.moved <= i64::from(self.high)
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
    /// The lowest and the highest coordinate in each place of the elements from `first` to before `end`.
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> [(i64, i64); MAX_AXES];
    /// Whether the launch has found that the coordinates lie within the field's shape.
    #[inline(always)]
    fn is_inside<S: Space>(self, _: &Cell<'_, S>) -> bool {
        false
    }
    /// Whether every coordinate lies between its extremes.
    fn holds(self) -> bool;
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
            fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> [(i64, i64); MAX_AXES] {
                let mut extremes = [(0, 0); MAX_AXES];
                $(extremes[$n] = self.$n.extremes(first, end);)+
                extremes
            }
            #[inline(always)]
            fn holds(self) -> bool {
                true $(& self.$n.holds())+
            }
        }
    )*};
}
places!(1: A 0; 2: A 0 B 1; 3: A 0 B 1 C 2; 4: A 0 B 1 C 2 D 3;);

/// Places whose extremes over the loop's box are part of what [`Run::fits`](crate::launch::Run) tells.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Boxed<T>(pub T);

impl<T: Places> Places for Boxed<T> {
    const COUNT: usize = T::COUNT;
    const VARIABLES: u32 = T::VARIABLES;
    #[inline(always)]
    fn coordinates<S: Space>(self, cell: &Cell<'_, S>) -> [i64; MAX_AXES] {
        self.0.coordinates(cell)
    }
    fn extremes(self, first: &[i64; MAX_AXES], end: &[i64; MAX_AXES]) -> [(i64, i64); MAX_AXES] {
        self.0.extremes(first, end)
    }
    #[inline(always)]
    fn is_inside<S: Space>(self, cell: &Cell<'_, S>) -> bool {
        cell.run.fits & self.0.holds()
    }
    #[inline(always)]
    fn holds(self) -> bool {
        self.0.holds()
    }
}

/// Coordinates that lie within a shape.
///
/// # Panics
/// Where they do not.
#[inline(always)]
#[track_caller]
pub(super) fn locate<S: Space, X: Axes, A: Places>(
    cell: &Cell<'_, S>,
    places: A,
    geometry: &Geometry,
    site: &'static Site,
) -> [u32; MAX_AXES] {
    const { assert!(A::COUNT == X::RANK, "an index has as many places as the field has axes") }
    let at = places.coordinates(cell);
    if !A::CHECKED || places.is_inside(cell) {
        return geometry.place(at);
    }
    within::<X>(at, geometry).unwrap_or_else(|| site.out_of_range::<X>(at, geometry))
}

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
        const { assert!(A::VARIABLES == (1 << S::RANK) - 1, "every loop variable stands in a place of an own index") }
        locate::<S, X, A>(cell, places, &self.handle.geometry, self.site)
    }

    /// The value there.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get<S: Space>(&self, cell: &Cell<'_, S>, places: impl Places) -> P::Value {
        let at = self.locate(cell, places);
        note::<R, L, X, P>(&self.handle, self.site, || at, Access::Read, Index::Own);
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
        unsafe { self.handle.write::<P>(at, value) };
        note::<R, L, X, P>(&self.handle, self.site, || at, Access::Write, Index::Own);
    }
}
