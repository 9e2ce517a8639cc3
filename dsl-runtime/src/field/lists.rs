//! Lists: fields in layouts with a `dynamic` node.

use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

use super::host::out_of_range;
use super::{Field, Handle, OutOfRange};
use crate::axes::{Axes, MAX_AXES};
use crate::index::{IntoIndex, within};
use crate::layout::{Geometry, ListLayout, Map};
use crate::record::{Path, Record, Whole};

/// A list that has no room for another entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListFull {
    /// The list's index.
    pub list: Vec<i64>,
    /// The most entries that it holds.
    pub most: usize,
}

impl fmt::Display for ListFull {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the list at {:?} holds {} entries, which is the maximum that its layout gives it",
            self.list, self.most
        )
    }
}

impl std::error::Error for ListFull {}

impl<R: Record, L: ListLayout<X>, X: Axes> Handle<'_, R, L, X> {
    /// The lists' axis, and the most entries of one.
    const LIST: (usize, usize) = match Map::<R, L, X>::list() {
        Some(list) => (list.axis, list.most),
        None => panic!("such a layout has lists"),
    };

    /// The place of the first entry of a list, whose index leaves out the lists' axis; with all its logical coordinates.
    #[inline(always)]
    pub(crate) fn list(&self, index: impl IntoIndex<X::Outer>) -> (Option<[u32; MAX_AXES]>, [i64; MAX_AXES]) {
        let (outer, axis) = (index.coordinates(), Self::LIST.0);
        let at = core::array::from_fn(|a| match a {
            _ if a == axis => i64::from(self.geometry.origin[a]),
            _ if a < axis => outer[a],
            _ => outer[a - 1],
        });
        (within::<X>(at, &self.geometry), at)
    }

    /// How many entries the list has whose first entry would be at a place.
    #[inline(always)]
    pub(crate) fn row_len_at(&self, at: [u32; MAX_AXES]) -> usize {
        self.list_len(&Self::split(0, at).0)
    }

    /// Puts a record behind the last of a list; `None` where it is full.
    #[inline(always)]
    pub(crate) fn append_at(&self, mut at: [u32; MAX_AXES], record: R) -> Option<usize> {
        let (axis, most) = Self::LIST;
        let (block, _) = Self::split(0, at);
        let store = self.store(0);
        let head = Map::<R, L, X>::head::<true>(&self.geometry, store, &block).expect("a list that was just made");
        let place = head.reserve(most)?;
        at[axis] = place as u32;
        let (block, inner) = Self::split(0, at);
        let found = self.brick(0, &block);
        let brick = if core::ptr::eq(found, store.background) { self.grow(0, &block) } else { found };
        store.mark();
        // SAFETY: the place was given to this call alone; its block is there, and readers of other entries do not touch it.
        unsafe {
            <Whole as Path<R>>::scatter(
                record,
                #[inline(always)]
                |m| self.component_in(m, brick, &inner),
            );
        }
        Some(place)
    }

    /// The message of a full list.
    pub(crate) fn full(&self, list: [i64; MAX_AXES]) -> ListFull {
        let (axis, most) = Self::LIST;
        ListFull { list: (0..X::RANK).filter(|&a| a != axis).map(|a| list[a]).collect(), most }
    }

    /// The indices of a list's entries, as they are now.
    pub(crate) fn entries_at(&self, at: [u32; MAX_AXES]) -> Entries<X> {
        let next = 0..self.row_len_at(at) as u32;
        Entries { geometry: self.geometry, at, axis: Self::LIST.0, next, axes: PhantomData }
    }
}

/// The indices of a list's entries: [`Field::row`].
#[derive(Clone, Debug)]
pub struct Entries<X> {
    geometry: Geometry,
    at: [u32; MAX_AXES],
    axis: usize,
    next: Range<u32>,
    axes: PhantomData<X>,
}

impl<X: Axes> Iterator for Entries<X> {
    type Item = X::Index;
    #[inline]
    fn next(&mut self) -> Option<X::Index> {
        self.at[self.axis] = self.next.next()?;
        Some(X::index(self.geometry.logical(self.at)))
    }
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.next.size_hint()
    }
}
impl<X: Axes> ExactSizeIterator for Entries<X> {}

impl<X: Axes> Entries<X> {
    /// The same as tuples.
    pub(crate) fn tuples(self) -> EntryTuples<X> {
        EntryTuples(self)
    }
}

/// The indices of a list's entries as tuples.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct EntryTuples<X>(Entries<X>);

impl<X: Axes> Iterator for EntryTuples<X> {
    type Item = X::Tuple;
    #[inline]
    fn next(&mut self) -> Option<X::Tuple> {
        self.0.next().map(|index| {
            let at = index.coordinates();
            X::tuple([at[0] as i32, at[1] as i32, at[2] as i32, at[3] as i32])
        })
    }
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }
}

impl<R: Record, L: ListLayout<X>, X: Axes> Field<R, L, X> {
    #[track_caller]
    fn list(&self, index: impl IntoIndex<X::Outer>) -> [u32; MAX_AXES] {
        let (at, logical) = self.handle().list(index);
        at.unwrap_or_else(|| out_of_range::<R>(&OutOfRange::at::<X>(logical, &self.geometry)))
    }

    /// Puts a record behind the last of a list, and returns its position there. The index leaves out the lists' axis.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut near = Field::<u32, layout!(dense(i).dynamic(j, 8).aos)>::new([100]);
    /// assert_eq!(near.append(7, 30), 0);
    /// assert_eq!(near.append(7, 31), 1);
    /// assert_eq!((near.row_len(7), near.get([7, 1])), (2, 31));
    /// ```
    ///
    /// # Panics
    /// Where the list is full, or the index lies outside of the shape.
    #[track_caller]
    pub fn append(&mut self, index: impl IntoIndex<X::Outer>, record: R) -> usize {
        let name = core::any::type_name::<R>();
        self.try_append(index, record).unwrap_or_else(|error| panic!("`Field<{name}, ..>`: {error}"))
    }

    /// Puts a record behind the last of a list, and returns its position there. The index leaves out the lists' axis.
    ///
    /// # Errors
    /// Where the list is full.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut queue = Field::<u8, layout!(dynamic(i, 2).aos)>::new([]);
    /// assert_eq!(queue.try_append((), 4), Ok(0));
    /// assert_eq!(queue.try_append((), 5), Ok(1));
    /// let error = queue.try_append((), 6).unwrap_err();
    /// assert_eq!(error.to_string(), "the list at [] holds 2 entries, which is the maximum that its layout gives it");
    /// ```
    #[track_caller]
    pub fn try_append(&mut self, index: impl IntoIndex<X::Outer>, record: R) -> Result<usize, ListFull> {
        let at = self.list(index);
        let (_, logical) = self.handle().list(index);
        let handle = self.handle_mut();
        handle.append_at(at, record).ok_or_else(|| handle.full(logical))
    }

    /// How many entries a list has.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn row_len(&self, index: impl IntoIndex<X::Outer>) -> usize {
        let at = self.list(index);
        self.handle().row_len_at(at)
    }

    /// The indices of a list's entries, whole ones, as they are now: the field need not stay borrowed.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut near = Field::<u32, layout!(dense(i).dynamic(j, 8).aos)>::new([100]);
    /// near.append(7, 30);
    /// near.append(7, 31);
    /// let sum: u32 = near.row(7).map(|entry| near.get(entry)).sum();
    /// assert_eq!(sum, 61);
    /// ```
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn row(&self, index: impl IntoIndex<X::Outer>) -> Entries<X> {
        let at = self.list(index);
        self.handle().entries_at(at)
    }

    /// Takes an entry out of its list; those behind it move up.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn remove(&mut self, entry: impl IntoIndex<X>) {
        self.deactivate(entry);
    }

    /// Shortens every list to at most `len` entries.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut queue = Field::<u8, layout!(dynamic(i, 1000).aos)>::new([]);
    /// (0..10).for_each(|n| assert_eq!(queue.append((), n), n.into()));
    /// queue.truncate(3);
    /// assert_eq!(queue.active_iter().map(|(_, value)| value).collect::<Vec<_>>(), [0, 1, 2]);
    /// ```
    pub fn truncate(&mut self, len: usize) {
        self.keep_entries(|n, _| n < len);
    }

    /// Keeps those entries of all lists that `keep` keeps, in their order.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut queue = Field::<u8, layout!(dynamic(i, 1000).aos)>::new([]);
    /// (0..10).for_each(|n| assert_eq!(queue.append((), n), n.into()));
    /// queue.retain(|value| value % 3 == 0);
    /// assert_eq!(queue.active_iter().map(|(_, value)| value).collect::<Vec<_>>(), [0, 3, 6, 9]);
    /// ```
    pub fn retain(&mut self, mut keep: impl FnMut(&R) -> bool) {
        self.keep_entries(|_, record| keep(record));
    }

    fn keep_entries(&mut self, mut keep: impl FnMut(usize, &R) -> bool) {
        let handle = self.handle_mut();
        let axis = Handle::<R, L, X>::LIST.0;
        // The first block of each list.
        let lists: Vec<_> =
            handle.actives(0).bricks.iter().map(|brick| brick.block).filter(|block| block[axis] == 0).collect();
        let extent = Map::<R, L, X>::chain(0).extent;
        for block in lists {
            let at = core::array::from_fn(|a| block[a] * extent[a] as u32);
            handle.retain_entries(&at, axis, &mut keep);
        }
    }
}
