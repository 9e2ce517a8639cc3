//! Putting a field's records into another order.

use core::fmt;

use super::elements::Elements;
use super::parts::{each_part, in_parts};
use super::{Field, Storage};
use crate::axes::{Axes, I};
use crate::layout::{Layout, Map};
use crate::record::{Record, Whole};

/// An order of records, such as [`Field::reorder_by_key`] makes: `old_places()[n]` is where the record now at `n` stood
/// before.
///
/// Ids that point into the reordered field are stale; [`new_places`](Self::new_places) translates them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Permutation {
    old: Vec<u32>,
}

/// Why a list of places is no permutation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PermutationError {
    /// A place lies beyond the list.
    OutOfRange {
        /// The record that goes there.
        record: usize,
        /// The place.
        place: u32,
        /// How many places there are.
        len: usize,
    },
    /// Two records go to one place.
    Twice {
        /// The later record that goes there.
        record: usize,
        /// The place.
        place: u32,
    },
}

impl fmt::Display for PermutationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { record, place, len } => {
                write!(f, "record {record} goes to place {place}, but there are {len} places")
            }
            Self::Twice { record, place } => {
                write!(f, "record {record} goes to place {place}, and so does one before it")
            }
        }
    }
}

impl std::error::Error for PermutationError {}

impl Permutation {
    /// The permutation that takes record `n` to `places[n]`.
    ///
    /// # Errors
    /// Where a place lies beyond the list, or two records go to one.
    ///
    /// ```
    /// use allotrope::Permutation;
    /// let order = Permutation::from_new_places(&[2, 0, 1])?;
    /// assert_eq!(order.old_places(), [1, 2, 0]);
    /// let error = Permutation::from_new_places(&[2, 0, 2]).unwrap_err();
    /// assert_eq!(error.to_string(), "record 2 goes to place 2, and so does one before it");
    /// # Ok::<(), allotrope::PermutationError>(())
    /// ```
    pub fn from_new_places(places: &[u32]) -> Result<Self, PermutationError> {
        let mut old: Vec<Option<u32>> = vec![None; places.len()];
        for (record, &place) in places.iter().enumerate() {
            match old.get_mut(place as usize) {
                None => return Err(PermutationError::OutOfRange { record, place, len: places.len() }),
                Some(Some(_)) => return Err(PermutationError::Twice { record, place }),
                // A place is below the length, which some `u32` is: so is the record's number.
                Some(free) => *free = Some(record as u32),
            }
        }
        Ok(Self { old: old.into_iter().flatten().collect() })
    }

    /// How many records it orders.
    pub fn len(&self) -> usize {
        self.old.len()
    }

    /// Whether it orders none.
    pub fn is_empty(&self) -> bool {
        self.old.is_empty()
    }

    /// The permutation that puts every record back.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { old: self.new_places() }
    }

    /// Where the record now at each place stood before.
    pub fn old_places(&self) -> &[u32] {
        &self.old
    }

    /// Where the record that stood at each place stands now.
    pub fn new_places(&self) -> Vec<u32> {
        let mut new = vec![0; self.old.len()];
        for (now, &before) in self.old.iter().enumerate() {
            new[before as usize] = now as u32;
        }
        new
    }
}

impl<R: Record, L: Layout<I>> Field<R, L, I> {
    /// Sorts whole records by a key, stably, all members at once, and returns the permutation. In a sparse field, the active elements'
    /// records are sorted, a list's entries; which elements are active stays as it is.
    ///
    /// The key is called once a record. Keys below the number of records (cells of a grid, say) are sorted by counting,
    /// in linear time.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut letters = Field::<u32, Aos>::new([4]);
    /// letters.copy_from_slice(&[30, 10, 20, 11]);
    /// let order = letters.reorder_by_key(|&value| value / 10);
    /// assert_eq!(letters.to_vec(), [10, 11, 20, 30]);
    /// assert_eq!(order.old_places(), [1, 3, 2, 0]);
    /// ```
    pub fn reorder_by_key<K: Into<u64>>(&mut self, key: impl Fn(&R) -> K + Sync) -> Permutation {
        let from = self.handle();
        let elements = Elements::of::<Whole, R, L, I>(&from);
        let mut keys = vec![0u64; elements.len()];
        in_parts(&mut keys, |first, keys| {
            let places = elements.part::<I>(first..first + keys.len());
            for (to, at) in keys.iter_mut().zip(places) {
                // SAFETY: elements lie within the shape; `&mut self` keeps writers away.
                *to = key(&unsafe { from.read::<Whole>(at) }).into();
            }
        });
        let mut old = stable_order(&keys);
        if const { Map::<R, L, I>::any_sparse() }
            && let Elements::Active(places) = &elements
        {
            // Activity stays as it is: the active elements' records change places among them.
            // SAFETY: as above.
            let record = |&n: &u32| unsafe { from.read::<Whole>(places[n as usize]) };
            let records = each_part(old.len(), |part| old[part].iter().map(record).collect::<Vec<R>>()).concat();
            each_part(old.len(), |part| {
                for n in part {
                    // SAFETY: each part writes its own elements, which `&mut self` keeps others from.
                    unsafe { from.write::<Whole>(places[n], records[n]) };
                }
            });
            return Permutation { old };
        }
        let storage = Storage::new_or_abort::<R, L, I>(&self.geometry);
        let to = from.at(storage.start());
        in_parts(&mut old, |first, old| {
            for (n, &mut before) in old.iter_mut().enumerate() {
                // SAFETY: `old` is a permutation of the field's places, of which each part writes its own; `storage` has
                // the field's geometry, and nobody reads it yet.
                unsafe { to.write::<Whole>(I::place((first + n) as u32), from.read::<Whole>(I::place(before))) };
            }
        });
        self.storage = storage;
        Permutation { old }
    }

    /// Puts record `n` of a source at the place that a permutation gives it: after a
    /// [`reorder_by_key`](Self::reorder_by_key), what belongs to the records but lies in another field follows them.
    ///
    /// No two records go to one place, which is what a kernel's `b[places[i]] = a[i]` cannot know.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut keys = Field::<u32, Aos>::new([3]);
    /// keys.copy_from_slice(&[30, 10, 20]);
    /// let mut names = Field::<u8, Soa>::new([3]);
    /// names.copy_from_slice(b"cab");
    /// let order = keys.reorder_by_key(|&key| key);
    /// let mut sorted = Field::<u8, Aos>::new([3]);
    /// sorted.scatter(&order, &names);
    /// assert_eq!(sorted.to_vec(), b"abc");
    /// names.scatter(&order.inverse(), &sorted);
    /// assert_eq!(names.to_vec(), b"cab");
    /// ```
    ///
    /// # Panics
    /// Where field, permutation and source are not of one length.
    #[track_caller]
    pub fn scatter<M: Layout<I>>(&mut self, permutation: &Permutation, source: &Field<R, M, I>) {
        let (from, to) = (source.handle(), self.handle());
        let (sources, places) = (Elements::of::<Whole, R, M, I>(&from), Elements::of::<Whole, R, L, I>(&to));
        assert!(
            permutation.len() == sources.len() && places.len() == sources.len(),
            "`scatter`: a field of {} elements, a permutation of {} and a source of {}",
            places.len(),
            permutation.len(),
            sources.len()
        );
        each_part(places.len(), |part| {
            for (n, at) in part.clone().zip(places.part::<I>(part)) {
                // SAFETY: a permutation's places lie within its length, which is that of both; each part writes its own
                // places of this field, which `&mut self` keeps others from.
                unsafe { to.write::<Whole>(at, from.read::<Whole>(sources.nth::<I>(permutation.old[n] as usize))) };
            }
        });
    }
}

impl I {
    /// The coordinates of a place on one axis.
    pub(super) fn place(n: u32) -> [u32; crate::axes::MAX_AXES] {
        const { assert!(<I as Axes>::RANK == 1) };
        [n, 0, 0, 0]
    }
}

/// The places of keys in ascending order, equal keys in their order.
fn stable_order(keys: &[u64]) -> Vec<u32> {
    let largest = keys.iter().copied().max().unwrap_or(0);
    let buckets = usize::try_from(largest).ok().and_then(|n| n.checked_add(1));
    match buckets {
        // Counting is linear as long as there are not many more buckets than records.
        Some(buckets) if buckets <= keys.len().saturating_mul(8).max(1024) => {
            let mut next = vec![0u32; buckets + 1];
            for &key in keys {
                next[key as usize + 1] += 1;
            }
            for b in 1..next.len() {
                next[b] += next[b - 1];
            }
            let mut old = vec![0; keys.len()];
            for (place, &key) in keys.iter().enumerate() {
                let now = &mut next[key as usize];
                old[*now as usize] = place as u32;
                *now += 1;
            }
            old
        }
        _ => {
            let mut old: Vec<u32> = (0..keys.len() as u32).collect();
            old.sort_by_key(|&place| keys[place as usize]);
            old
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counting_and_sorting_agree() {
        let mut state = 1u64;
        let keys: Vec<u64> = (0..5000)
            .map(|_| {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (state >> 33) % 700
            })
            .collect();
        let far: Vec<u64> = keys.iter().map(|&key| key << 40).collect();
        assert_eq!(stable_order(&keys), stable_order(&far));
    }
}
