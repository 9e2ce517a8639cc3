//! `Read`: a path that the loop only reads, at any index.

use super::lane::Lane;
use super::{Based, Places, Site};
use crate::axes::Axes;
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::launch::{Cell, Space};
use crate::layout::{Layout, ListLayout};
use crate::probe::Index;
use crate::record::{Path, Record};

/// Reads a path of a field at any index. Nothing in the loop writes it.
#[doc(hidden)]
#[derive(Debug)]
pub struct Read<'a, R, L, X, P>(Lane<'a, R, L, X, P>);

impl<R, L, X, P> Clone for Read<'_, R, L, X, P> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P> Copy for Read<'_, R, L, X, P> {}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> Read<'a, R, L, X, P> {
    #[inline(always)]
    pub(crate) fn new(handle: Handle<'a, R, L, X>, site: &'static Site) -> Self {
        Self(Lane::new(handle, site))
    }

    /// The same for a function that it is handed to.
    #[inline(always)]
    pub fn lent(&self) -> Self {
        *self
    }

    #[inline(always)]
    pub(super) fn handle(&self) -> &Handle<'a, R, L, X> {
        self.0.handle()
    }

    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> P::Value {
        let at = self.0.locate(index);
        // SAFETY: `at` lies within the shape, and the launch holds the field's borrow under which nothing writes this path.
        unsafe { self.0.read(at, Index::Computed) }
    }

    /// The value where the loop's variables stand in an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get_in<S: Space>(&self, cell: &Cell<'_, S>, places: impl Places) -> P::Value {
        let at = super::free::locate::<S, X, _>(cell, places, &self.0.handle().geometry, self.0.site());
        // SAFETY: as in `get`: what `locate` returns lies within the shape.
        unsafe { self.0.read(at, Index::Computed) }
    }

    /// The value of the element nearest to an index.
    ///
    /// # Panics
    /// Where the field has no element.
    #[inline(always)]
    #[track_caller]
    pub fn clamped(&self, index: impl IntoIndex<X>) -> P::Value {
        let at = self.0.locate_by(index, crate::index::clamped::<X>);
        // SAFETY: as in `get`: what `clamped` returns lies within the shape.
        unsafe { self.0.read(at, Index::Computed) }
    }

    /// The value at an index modulo the extents.
    ///
    /// # Panics
    /// Where the field has no element, or the index is larger than an `i64`.
    #[inline(always)]
    #[track_caller]
    pub fn wrapped(&self, index: impl IntoIndex<X>) -> P::Value {
        let at = self.0.locate_by(index, crate::index::wrapped::<X>);
        // SAFETY: as in `get`: what `wrapped` returns lies within the shape.
        unsafe { self.0.read(at, Index::Computed) }
    }

    /// The value at an index, or `value` where it lies outside of the shape.
    #[inline(always)]
    pub fn or(&self, index: impl IntoIndex<X>, value: P::Value) -> P::Value {
        match self.0.inside(index) {
            // SAFETY: as in `get`: what `inside` returns lies within the shape.
            Some(at) => unsafe { self.0.read(at, Index::Computed) },
            None => value,
        }
    }

    /// How many entries a list has.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn row_len(&self, list: impl IntoIndex<X::Outer>) -> usize
    where
        L: ListLayout<X>,
    {
        let (at, logical) = self.handle().list(list);
        let Some(at) = at else { self.0.site().out_of_range::<X>(logical, &self.handle().geometry) };
        self.handle().row_len_at(at)
    }

    /// The value at `base + offset`, checked with the base where the offset lies in the base's box.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get_at<const FILLED: bool>(&self, base: &Based<'_, L, X, FILLED>, offset: impl IntoIndex<X>) -> P::Value {
        let near = self.0.near(base, offset);
        // SAFETY: as in `get`; the base was made from this field.
        unsafe { self.0.read(near, Index::Computed) }
    }
}
