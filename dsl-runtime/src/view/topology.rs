//! What a loop asks of a field's activity, and does to it.

use super::probed::note;
use super::{Site, View};
use crate::axes::{Axes, MAX_AXES};
use crate::field::Entries;
use crate::index::IntoIndex;
use crate::layout::{Layout, ListLayout, Map};
use crate::probe::{Access, Index};
use crate::record::{ElementList, Path, Record, Whole};

impl<R: Record, L: Layout<X>, X: Axes, const WRITE: bool> View<'_, R, L, X, WRITE> {
    #[inline(always)]
    #[track_caller]
    fn place(&self, index: impl IntoIndex<X>) -> [u32; MAX_AXES] {
        let at = index.coordinates();
        let Some(place) = crate::index::within::<X>(at, &self.handle.geometry) else {
            self.site.out_of_range::<X>(at, &self.handle.geometry)
        };
        place
    }

    /// Whether an element is active, in any branch that holds some of what a path names.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn is_active<P: Path<R>>(&self, _: P, index: impl IntoIndex<X>) -> bool {
        let at = self.place(index);
        branches::<R, L, X, P>().any(|m| self.handle.is_active_at(m, at))
    }
}

/// A member of each branch that holds some of what a path names.
#[inline(always)]
fn branches<R: Record, L: Layout<X>, X: Axes, P: Path<R>>() -> impl Iterator<Item = usize> {
    let all = P::OFFSET..P::OFFSET + <P::Value as Record>::Elements::MEMBERS.len();
    let new = |&m: &usize| (P::OFFSET..m).all(|other| Map::<R, L, X>::branch(other) != Map::<R, L, X>::branch(m));
    all.filter(move |m| m == &P::OFFSET || (L::BRANCHES > 1 && new(m)))
}

impl<R: Record, L: Layout<X>, X: Axes> View<'_, R, L, X, true> {
    /// Makes an element active, in all branches that hold some of what a path names.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn activate<P: Path<R>>(&self, _: P, index: impl IntoIndex<X>) {
        let at = self.place(index);
        branches::<R, L, X, P>().for_each(|m| self.handle.activate_at(m, at));
    }

    /// Makes an element inactive when the loop ends.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn deactivate<P: Path<R>>(&self, _: P, index: impl IntoIndex<X>) {
        let at = self.place(index);
        branches::<R, L, X, P>().filter(|&m| Map::<R, L, X>::is_sparse(m)).for_each(|m| self.handle.defer(m, at));
    }

    /// Makes inactive what the loop has deactivated and removed.
    pub fn settle(self) {
        self.handle.settle();
    }
}

impl<R: Record, L: ListLayout<X>, X: Axes, const WRITE: bool> View<'_, R, L, X, WRITE> {
    #[inline(always)]
    #[track_caller]
    fn list(&self, index: impl IntoIndex<X::Outer>) -> ([u32; MAX_AXES], [i64; MAX_AXES]) {
        let (at, logical) = self.handle.list(index);
        let Some(at) = at else { self.site.out_of_range::<X>(logical, &self.handle.geometry) };
        (at, logical)
    }

    /// How many entries a list has.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn row_len(&self, index: impl IntoIndex<X::Outer>) -> usize {
        self.handle.row_len_at(self.list(index).0)
    }

    /// The indices of a list's entries, as they are now.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn entries(&self, index: impl IntoIndex<X::Outer>) -> Entries<X> {
        self.handle.entries_at(self.list(index).0)
    }

    /// The same as tuples.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn entry_tuples(&self, index: impl IntoIndex<X::Outer>) -> impl Iterator<Item = X::Tuple> {
        self.handle.entries_at(self.list(index).0).tuples()
    }
}

impl<R: Record, L: ListLayout<X>, X: Axes> View<'_, R, L, X, true> {
    /// Puts a record behind the last of a list, and returns its position there.
    ///
    /// # Panics
    /// Where the list is full, or the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn append(&self, index: impl IntoIndex<X::Outer>, record: R) -> usize {
        let (at, logical) = self.list(index);
        let Some(position) = self.handle.append_at(at, record) else { self.full(logical) };
        self.note_entry(at, position);
        position
    }

    /// Tells a recording of an entry that was appended.
    #[inline(always)]
    fn note_entry(&self, mut list: [u32; MAX_AXES], position: usize) {
        list[X::RANK - 1] = position as u32;
        note::<R, L, X, Whole>(&self.handle, self.site, || list, Access::Write, Index::Computed);
    }

    /// Puts a record behind the last of a list, and returns its position there; `None` where the list is full.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn try_append(&self, index: impl IntoIndex<X::Outer>, record: R) -> Option<usize> {
        let at = self.list(index).0;
        let position = self.handle.append_at(at, record)?;
        self.note_entry(at, position);
        Some(position)
    }

    /// Takes an entry out of its list when the loop ends.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn remove(&self, entry: impl IntoIndex<X>) {
        self.handle.defer(0, self.place(entry));
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn full(&self, list: [i64; MAX_AXES]) -> ! {
        let Site { kernel, field } = self.site;
        panic!("kernel `{kernel}`: `append` to the field `{field}`: {}", self.handle.full(list))
    }
}
