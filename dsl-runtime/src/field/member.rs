//! Host access to single members: `field.members().mass.to_vec()`.

use super::host::{Places, out_of_range};
use super::{Field, Handle, OutOfRange};
use crate::axes::Axes;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::record::{At, ElementList, Record, Tag};

/// One member of a field, to read.
pub struct Member<'a, R, L, X, const M: usize>(Handle<'a, R, L, X>);

/// One member of a field, to change. No two of them alias.
pub struct MemberMut<'a, R, L, X, const M: usize>(Handle<'a, R, L, X>);

impl<R, L, X, const M: usize> Clone for Member<'_, R, L, X, M> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, const M: usize> Copy for Member<'_, R, L, X, M> {}
impl<R, L, X, const M: usize> core::fmt::Debug for Member<'_, R, L, X, M> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Member {M}")
    }
}
impl<R, L, X, const M: usize> core::fmt::Debug for MemberMut<'_, R, L, X, M> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "MemberMut {M}")
    }
}

impl<'a, R, L, X, const M: usize> Member<'a, R, L, X, M> {
    pub(crate) fn new(handle: Handle<'a, R, L, X>) -> Self {
        Self(handle)
    }
    pub(super) fn handle(&self) -> &Handle<'a, R, L, X> {
        &self.0
    }
}
impl<'a, R, L, X, const M: usize> MemberMut<'a, R, L, X, M> {
    pub(crate) fn new(handle: Handle<'a, R, L, X>) -> Self {
        Self(handle)
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
    pub fn members(&self) -> R::Members<'_, L, X> {
        R::members(R::Elements::members(self.handle()))
    }

    /// The members, one public field each, to change: the borrow checker keeps them apart.
    pub fn members_mut(&mut self) -> R::MembersMut<'_, L, X> {
        R::members_mut(R::Elements::members_mut(self.handle()))
    }
}

impl<R: Record, L: Layout<X>, X: Axes, const M: usize> Member<'_, R, L, X, M>
where
    R::Elements: At<M>,
{
    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> <R::Elements as At<M>>::Element {
        get(&self.0, index)
    }

    /// All values in logical row-major order.
    pub fn to_vec(&self) -> Vec<<R::Elements as At<M>>::Element> {
        to_vec(&self.0)
    }
}

impl<R: Record, L: Layout<X>, X: Axes, const M: usize> MemberMut<'_, R, L, X, M>
where
    R::Elements: At<M>,
{
    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> <R::Elements as At<M>>::Element {
        get(&self.0, index)
    }

    /// All values in logical row-major order.
    pub fn to_vec(&self) -> Vec<<R::Elements as At<M>>::Element> {
        to_vec(&self.0)
    }

    /// Puts a value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn set(&mut self, index: impl IntoIndex<X>, value: <R::Elements as At<M>>::Element) {
        let Some(at) = self.0.locate(index) else { missed::<R, L, X>(&self.0, index) };
        // SAFETY: `locate` returns indices within the shape; this member is ours alone.
        unsafe { self.0.write::<Tag<R, M>>(at, value) };
    }

    /// Puts the same value everywhere.
    pub fn fill(&mut self, value: <R::Elements as At<M>>::Element) {
        for at in Places::<X>::new(self.0.geometry.shape) {
            // SAFETY: places lie within the shape; this member is ours alone.
            unsafe { self.0.write::<Tag<R, M>>(at, value) };
        }
    }

    /// Takes all values from a slice in logical row-major order.
    ///
    /// # Panics
    /// Where the slice has not as many values as the field has elements.
    #[track_caller]
    pub fn copy_from_slice(&mut self, values: &[<R::Elements as At<M>>::Element]) {
        let places = Places::<X>::new(self.0.geometry.shape);
        assert!(
            values.len() == places.len(),
            "`copy_from_slice`: {} values for a field of {} elements",
            values.len(),
            places.len()
        );
        for (at, &value) in places.zip(values) {
            // SAFETY: places lie within the shape; this member is ours alone.
            unsafe { self.0.write::<Tag<R, M>>(at, value) };
        }
    }
}

#[track_caller]
fn get<R: Record, L: Layout<X>, X: Axes, const M: usize>(
    handle: &Handle<'_, R, L, X>,
    index: impl IntoIndex<X>,
) -> <R::Elements as At<M>>::Element
where
    R::Elements: At<M>,
{
    let Some(at) = handle.locate(index) else { missed::<R, L, X>(handle, index) };
    // SAFETY: `locate` returns indices within the shape; the member's borrow keeps writers away.
    unsafe { handle.read::<Tag<R, M>>(at) }
}

fn to_vec<R: Record, L: Layout<X>, X: Axes, const M: usize>(
    handle: &Handle<'_, R, L, X>,
) -> Vec<<R::Elements as At<M>>::Element>
where
    R::Elements: At<M>,
{
    Places::<X>::new(handle.geometry.shape)
        // SAFETY: places lie within the shape; the member's borrow keeps writers away.
        .map(|at| unsafe { handle.read::<Tag<R, M>>(at) })
        .collect()
}

#[cold]
#[track_caller]
fn missed<R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'_, R, L, X>, index: impl IntoIndex<X>) -> ! {
    out_of_range::<R>(&OutOfRange {
        index: index.coordinates()[..X::RANK].to_vec(),
        shape: handle.geometry.extents::<X>().as_ref().to_vec(),
    })
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
