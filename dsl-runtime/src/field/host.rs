//! Host access to whole records: get, set, iterate, fill.

use core::ops::Range;

use super::elements::Elements;
use super::{Field, Handle, OutOfRange};
use crate::axes::{Axes, MAX_AXES};
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::record::{ElementList, Record, Whole};

#[cold]
#[inline(never)]
#[track_caller]
pub(crate) fn out_of_range<R>(error: &OutOfRange) -> ! {
    panic!("`Field<{}, ..>`: {error}", core::any::type_name::<R>())
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    pub(crate) fn find(&self, index: impl IntoIndex<X>) -> Result<[u32; MAX_AXES], OutOfRange> {
        self.handle().locate(index).ok_or_else(|| OutOfRange::new(index, &self.geometry))
    }

    /// The record at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> R {
        self.try_get(index).unwrap_or_else(|error| out_of_range::<R>(&error))
    }

    /// The record at an index.
    ///
    /// # Errors
    /// Where the index lies outside of the shape.
    pub fn try_get(&self, index: impl IntoIndex<X>) -> Result<R, OutOfRange> {
        let at = self.find(index)?;
        // SAFETY: `find` returns indices within the shape; `&self` keeps writers away.
        Ok(unsafe { self.handle().read::<Whole>(at) })
    }

    /// Puts a record at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn set(&mut self, index: impl IntoIndex<X>, record: R) {
        self.try_set(index, record).unwrap_or_else(|error| out_of_range::<R>(&error));
    }

    /// Puts a record at an index.
    ///
    /// # Errors
    /// Where the index lies outside of the shape.
    pub fn try_set(&mut self, index: impl IntoIndex<X>, record: R) -> Result<(), OutOfRange> {
        let at = self.find(index)?;
        // SAFETY: `find` returns indices within the shape; `&mut self` is exclusive.
        unsafe { self.handle_mut().write::<Whole>(at, record) };
        Ok(())
    }

    /// Puts the same record everywhere; in a sparse field, into the active elements.
    pub fn fill(&mut self, record: R) {
        let handle = self.handle_mut();
        if L::BRANCHES > 1 {
            // Each branch has its own active elements.
            for m in 0..R::Elements::MEMBERS.len() {
                for at in Elements::of_member(&handle, m).all::<X>() {
                    // SAFETY: elements lie within the shape; `&mut self` is exclusive.
                    unsafe { handle.write_member(m, at, record) };
                }
            }
            return;
        }
        for at in Elements::of::<Whole, R, L, X>(&handle).all::<X>() {
            // SAFETY: elements lie within the shape; `&mut self` is exclusive.
            unsafe { handle.write::<Whole>(at, record) };
        }
    }

    /// The records in logical row-major order.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut u = Field::<i32, Blocked<2>>::new([2, 3]);
    /// for (n, at) in [[0, 0], [0, 1], [0, 2], [1, 0]].into_iter().enumerate() {
    ///     u.set(at, n as i32);
    /// }
    /// assert_eq!(u.iter().collect::<Vec<_>>(), [0, 1, 2, 3, 0, 0]);
    /// ```
    pub fn iter(&self) -> Records<'_, R, L, X> {
        Records { places: Places::new(self.geometry.shape), handle: self.handle() }
    }
}

/// Places within a shape, in logical row-major order, from either end.
#[derive(Clone, Debug)]
pub(crate) struct Places<X> {
    shape: [u32; MAX_AXES],
    next: [u32; MAX_AXES],
    left: Range<usize>,
    axes: core::marker::PhantomData<X>,
}

impl<X: Axes> Places<X> {
    /// All of them.
    pub(crate) fn new(shape: [u32; MAX_AXES]) -> Self {
        let len = shape.iter().fold(1, |len: usize, &n| len.saturating_mul(n as usize));
        Self { shape, next: [0; MAX_AXES], left: 0..len, axes: core::marker::PhantomData }
    }

    /// Those whose numbers in row-major order lie in a range, which ends at the last place or before.
    pub(crate) fn part(shape: [u32; MAX_AXES], part: Range<usize>) -> Self {
        let mut this = Self::new(shape);
        assert!(part.start <= part.end && part.end <= this.left.end, "places that the shape has");
        this.next = Self::numbered(shape, part.start);
        this.left = part;
        this
    }

    /// The place of a number in row-major order. Divides once an axis: for ends and jumps.
    pub(crate) fn numbered(shape: [u32; MAX_AXES], number: usize) -> [u32; MAX_AXES] {
        let (mut at, mut rest) = ([0; MAX_AXES], number);
        for axis in (0..X::RANK).rev() {
            let extent = (shape[axis] as usize).max(1);
            at[axis] = (rest % extent) as u32;
            rest /= extent;
        }
        at
    }

    /// The two halves at a number of places from here.
    fn split_at(self, count: usize) -> (Self, Self) {
        let middle = self.left.start + count;
        (Self::part(self.shape, self.left.start..middle), Self::part(self.shape, middle..self.left.end))
    }
}

impl<X: Axes> Iterator for Places<X> {
    type Item = [u32; MAX_AXES];
    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        self.left.next()?;
        let at = self.next;
        for axis in (0..X::RANK).rev() {
            self.next[axis] += 1;
            if self.next[axis] < self.shape[axis] {
                break;
            }
            self.next[axis] = 0;
        }
        Some(at)
    }
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.left.size_hint()
    }
}
impl<X: Axes> DoubleEndedIterator for Places<X> {
    fn next_back(&mut self) -> Option<Self::Item> {
        let number = self.left.next_back()?;
        Some(Self::numbered(self.shape, number))
    }
}
impl<X: Axes> ExactSizeIterator for Places<X> {}

/// The records of a field in logical row-major order.
pub struct Records<'a, R, L, X> {
    places: Places<X>,
    handle: Handle<'a, R, L, X>,
}

impl<R, L, X> core::fmt::Debug for Records<'_, R, L, X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Records({} left)", self.places.left.len())
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Iterator for Records<'_, R, L, X> {
    type Item = R;
    fn next(&mut self) -> Option<R> {
        let at = self.places.next()?;
        // SAFETY: places lie within the shape; the iterator borrows the field, which keeps writers away.
        Some(unsafe { self.handle.read::<Whole>(at) })
    }
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.places.size_hint()
    }
}
impl<R: Record, L: Layout<X>, X: Axes> DoubleEndedIterator for Records<'_, R, L, X> {
    fn next_back(&mut self) -> Option<R> {
        let at = self.places.next_back()?;
        // SAFETY: as for `next`.
        Some(unsafe { self.handle.read::<Whole>(at) })
    }
}
impl<R: Record, L: Layout<X>, X: Axes> ExactSizeIterator for Records<'_, R, L, X> {}

impl<R: Record, L: Layout<X>, X: Axes> Records<'_, R, L, X> {
    /// The first `count` of them, and the others.
    pub(crate) fn split_at(self, count: usize) -> (Self, Self) {
        let (first, second) = self.places.split_at(count);
        (Self { places: first, handle: self.handle }, Self { places: second, handle: self.handle })
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes> IntoIterator for &'a Field<R, L, X> {
    type Item = R;
    type IntoIter = Records<'a, R, L, X>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
