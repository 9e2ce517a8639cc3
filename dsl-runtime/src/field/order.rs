//! Putting a field's records into another order.

use std::sync::{Mutex, PoisonError};

use super::{Field, Memory};
use crate::axes::{Axes, I};
use crate::launch::run_jobs;
use crate::layout::{Layout, Map};
use crate::record::{Record, Whole};
use crate::schedule::Schedule;

/// The order that [`Field::reorder_by_key`] made: `old[n]` is where the record now at `n` stood before.
///
/// Ids that point into the reordered field are stale; [`new_places`](Self::new_places) translates them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Permutation {
    old: Vec<u32>,
}

impl Permutation {
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
    /// Sorts whole records by a key, stably, all members at once, and returns the permutation.
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
        let threads = Schedule::current().thread_count();
        let from = self.handle();
        let mut keys = vec![0u64; self.len()];
        in_parts(threads, &mut keys, |first, keys| {
            for (n, to) in keys.iter_mut().enumerate() {
                // SAFETY: the place lies within the shape; `&mut self` keeps writers away.
                *to = key(&unsafe { from.read::<Whole>(I::place((first + n) as u32)) }).into();
            }
        });
        let mut old = stable_order(&keys);
        let memory = Memory::zeroed_or_abort(self.memory.bytes(), Map::<R, L, I>::LINE);
        let to = from.at(memory.start());
        in_parts(threads, &mut old, |first, old| {
            for (n, &mut before) in old.iter_mut().enumerate() {
                // SAFETY: `old` is a permutation of the field's places, of which each part writes its own; `memory` has
                // the field's geometry, and nobody reads it yet.
                unsafe { to.write::<Whole>(I::place((first + n) as u32), from.read::<Whole>(I::place(before))) };
            }
        });
        self.memory = memory;
        Permutation { old }
    }
}

/// Records that one job takes.
const PART: usize = 1 << 15;

/// Works on the parts of a list in parallel. `work` is told where its part begins.
fn in_parts<T: Send>(threads: usize, list: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
    let parts: Vec<Mutex<&mut [T]>> = list.chunks_mut(PART).map(Mutex::new).collect();
    run_jobs(threads, parts.len(), &|part| {
        let mut list = parts[part].lock().unwrap_or_else(PoisonError::into_inner);
        work(part * PART, &mut list);
    });
}

impl I {
    /// The coordinates of a place on one axis.
    fn place(n: u32) -> [u32; crate::axes::MAX_AXES] {
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
