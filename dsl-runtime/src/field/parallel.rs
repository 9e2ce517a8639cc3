//! A field's records as a parallel iterator of rayon's.

use rayon::iter::plumbing::{Consumer, Producer, ProducerCallback, UnindexedConsumer, bridge};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use super::{Field, Records};
use crate::axes::Axes;
use crate::layout::Layout;
use crate::record::Record;

/// The records of a field in logical row-major order, for rayon: [`Field::par_iter`].
#[derive(Debug)]
pub struct ParallelRecords<'a, R, L, X>(Records<'a, R, L, X>);

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// The records in logical row-major order, as an indexed parallel iterator of [rayon](https://docs.rs/rayon)'s.
    ///
    /// It runs on the threads of rayon's own pool, not on those of the [`Schedule`](crate::Schedule), and rayon cuts
    /// the work as it likes: a sum of floats that is to have the same bits each time is for [`reduce`](Self::reduce).
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// use rayon::iter::{IndexedParallelIterator, ParallelIterator};
    /// let mut u = Field::<i32, Blocked<2>>::new([2, 3]);
    /// u.copy_from_slice(&[4, 0, 5, 0, 6, 0]);
    /// let doubled: Vec<i32> = u.par_iter().map(|value| 2 * value).collect();
    /// assert_eq!(doubled, [8, 0, 10, 0, 12, 0]);
    /// assert_eq!(u.par_iter().position_first(|value| value == 5), Some(2));
    /// ```
    pub fn par_iter(&self) -> ParallelRecords<'_, R, L, X> {
        ParallelRecords(self.iter())
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes> IntoParallelIterator for &'a Field<R, L, X> {
    type Item = R;
    type Iter = ParallelRecords<'a, R, L, X>;
    fn into_par_iter(self) -> Self::Iter {
        self.par_iter()
    }
}

impl<R: Record, L: Layout<X>, X: Axes> ParallelIterator for ParallelRecords<'_, R, L, X> {
    type Item = R;
    fn drive_unindexed<C: UnindexedConsumer<R>>(self, consumer: C) -> C::Result {
        bridge(self, consumer)
    }
    fn opt_len(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

impl<R: Record, L: Layout<X>, X: Axes> IndexedParallelIterator for ParallelRecords<'_, R, L, X> {
    fn len(&self) -> usize {
        self.0.len()
    }
    fn drive<C: Consumer<R>>(self, consumer: C) -> C::Result {
        bridge(self, consumer)
    }
    fn with_producer<C: ProducerCallback<R>>(self, callback: C) -> C::Output {
        callback.callback(Part(self.0))
    }
}

/// What one of rayon's jobs takes.
struct Part<'a, R, L, X>(Records<'a, R, L, X>);

impl<'a, R: Record, L: Layout<X>, X: Axes> Producer for Part<'a, R, L, X> {
    type Item = R;
    type IntoIter = Records<'a, R, L, X>;
    fn into_iter(self) -> Self::IntoIter {
        self.0
    }
    fn split_at(self, index: usize) -> (Self, Self) {
        let (first, second) = self.0.split_at(index);
        (Self(first), Self(second))
    }
}
