//! Host access to single members: `field.members().mass.to_vec()`.

use core::marker::PhantomData;

use super::elements::Elements;
use super::host::{Places, out_of_range};
use super::{Field, Handle, OutOfRange};
use crate::axes::Axes;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::record::{ElementList, Path, Record, Whole};

/// One member of a field, to read.
pub struct Member<'a, R, L, X, P>(Handle<'a, R, L, X>, PhantomData<P>);

/// One member of a field, to change. No two of them alias.
pub struct MemberMut<'a, R, L, X, P>(Handle<'a, R, L, X>, PhantomData<P>);

impl<R, L, X, P> Clone for Member<'_, R, L, X, P> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P> Copy for Member<'_, R, L, X, P> {}
impl<R, L, X, P> core::fmt::Debug for Member<'_, R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Member({})", core::any::type_name::<P>())
    }
}
impl<R, L, X, P> core::fmt::Debug for MemberMut<'_, R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "MemberMut({})", core::any::type_name::<P>())
    }
}

impl<'a, R, L, X, P> Member<'a, R, L, X, P> {
    pub(crate) fn new(handle: Handle<'a, R, L, X>) -> Self {
        Self(handle, PhantomData)
    }
    pub(super) fn handle(&self) -> &Handle<'a, R, L, X> {
        &self.0
    }
}
impl<'a, R, L, X, P> MemberMut<'a, R, L, X, P> {
    pub(crate) fn new(handle: Handle<'a, R, L, X>) -> Self {
        Self(handle, PhantomData)
    }
    pub(super) fn handle(&self) -> &Handle<'a, R, L, X> {
        &self.0
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// The members, one public field each, to read.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// #[derive(Record, Clone, Copy, Default)]
    /// struct Node {
    ///     velocity: Vec2,
    ///     mass: f32,
    /// }
    /// let mut grid = Field::<Node, Soa>::new([2, 2]);
    /// grid.members_mut().mass.fill(0.5);
    /// assert_eq!(grid.members().mass.to_vec(), [0.5; 4]);
    /// ```
    pub fn members(&self) -> R::Members<'_, R, Whole, L, X> {
        R::members(R::Elements::members::<R, Whole, L, X>(self.handle()))
    }

    /// The members, one public field each, to change: the borrow checker keeps them apart.
    pub fn members_mut(&mut self) -> R::MembersMut<'_, R, Whole, L, X> {
        R::members_mut(R::Elements::members_mut::<R, Whole, L, X>(self.handle()))
    }
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Member<'_, R, L, X, P> {
    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> P::Value {
        get::<P, _, _, _>(&self.0, index)
    }

    /// All values in logical row-major order.
    pub fn to_vec(&self) -> Vec<P::Value> {
        to_vec::<P, _, _, _>(&self.0)
    }
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> MemberMut<'_, R, L, X, P> {
    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> P::Value {
        get::<P, _, _, _>(&self.0, index)
    }

    /// All values in logical row-major order.
    pub fn to_vec(&self) -> Vec<P::Value> {
        to_vec::<P, _, _, _>(&self.0)
    }

    /// Puts a value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn set(&mut self, index: impl IntoIndex<X>, value: P::Value) {
        let Some(at) = self.0.locate(index) else { missed::<R, L, X>(&self.0, index) };
        // SAFETY: `locate` returns indices within the shape; this member is ours alone.
        unsafe { self.0.write::<P>(at, value) };
    }

    /// Puts the same value everywhere; in a sparse field, into the active elements.
    pub fn fill(&mut self, value: P::Value) {
        for at in Elements::of::<P, R, L, X>(&self.0).all::<X>() {
            // SAFETY: elements lie within the shape; this member is ours alone.
            unsafe { self.0.write::<P>(at, value) };
        }
    }

    /// Takes all values from a slice in logical row-major order.
    ///
    /// # Panics
    /// Where the slice has not as many values as the field has elements.
    #[track_caller]
    pub fn copy_from_slice(&mut self, values: &[P::Value]) {
        let places = Places::<X>::new(self.0.geometry.shape);
        assert!(
            values.len() == places.len(),
            "`copy_from_slice`: {} values for a field of {} elements",
            values.len(),
            places.len()
        );
        for (at, &value) in places.zip(values) {
            // SAFETY: places lie within the shape; this member is ours alone.
            unsafe { self.0.write::<P>(at, value) };
        }
    }
}

#[track_caller]
fn get<P: Path<R>, R: Record, L: Layout<X>, X: Axes>(
    handle: &Handle<'_, R, L, X>,
    index: impl IntoIndex<X>,
) -> P::Value {
    let Some(at) = handle.locate(index) else { missed::<R, L, X>(handle, index) };
    // SAFETY: `locate` returns indices within the shape; the member's borrow keeps writers away.
    unsafe { handle.read::<P>(at) }
}

fn to_vec<P: Path<R>, R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'_, R, L, X>) -> Vec<P::Value> {
    Places::<X>::new(handle.geometry.shape)
        // SAFETY: places lie within the shape; the member's borrow keeps writers away.
        .map(|at| unsafe { handle.read::<P>(at) })
        .collect()
}

#[cold]
#[track_caller]
fn missed<R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'_, R, L, X>, index: impl IntoIndex<X>) -> ! {
    out_of_range::<R>(&OutOfRange::new(index, &handle.geometry))
}

/// Fields of bare elements need not name their one member.
impl<E: crate::element::Element, L: Layout<X>, X: Axes> Field<E, L, X> {
    /// All values in logical row-major order.
    pub fn to_vec(&self) -> Vec<E> {
        self.iter().collect()
    }

    /// Takes all values from a slice in logical row-major order.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut u = Field::<f32, layout!(dense(ji).aos)>::new([2, 2]);
    /// u.copy_from_slice(&[1.0, 2.0, 3.0, 4.0]);
    /// assert_eq!(u.get([0, 1]), 2.0);
    /// ```
    ///
    /// # Panics
    /// Where the slice has not as many values as the field has elements.
    #[track_caller]
    pub fn copy_from_slice(&mut self, values: &[E]) {
        self.members_mut().0.copy_from_slice(values);
    }
}
