//! The heads of lists: how many entries each has, and who takes the next place.

use super::slot::Slot;
use super::sync::{AtomicU32, Ordering};

/// A list: how many entries it has, and where they lie. Zeroed memory is an empty list.
#[derive(Debug)]
#[repr(C)]
#[doc(hidden)]
pub struct Head {
    /// Entries, and for a moment those that found the list full.
    len: AtomicU32,
    /// Its block, or the pointers to its blocks.
    pub(crate) data: Slot,
}

impl Head {
    /// An empty list.
    #[cfg(test)]
    #[allow(dead_code, reason = "the tests that model it make one")]
    pub(crate) fn empty() -> Self {
        Self { len: AtomicU32::new(0), data: Slot::empty() }
    }

    /// How many entries there are.
    #[inline(always)]
    pub(crate) fn len(&self, most: usize) -> usize {
        (self.len.load(Ordering::Relaxed) as usize).min(most)
    }

    /// Takes the place behind the last entry, if there is one.
    #[inline(always)]
    pub(crate) fn reserve(&self, most: usize) -> Option<usize> {
        // A full list is told without a write, so that its count never grows far beyond.
        if self.len.load(Ordering::Relaxed) as usize >= most {
            return None;
        }
        let place = self.len.fetch_add(1, Ordering::Relaxed) as usize;
        if place >= most {
            self.len.fetch_sub(1, Ordering::Relaxed);
            return None;
        }
        Some(place)
    }

    /// Makes the list have so many entries at least. Returns whether it had fewer.
    #[inline(always)]
    pub(crate) fn extend(&self, len: usize) -> bool {
        (self.len.load(Ordering::Relaxed) as usize) < len
            && (self.len.fetch_max(len as u32, Ordering::Relaxed) as usize) < len
    }

    /// Sets the number of entries. The caller has the list to itself.
    pub(crate) fn set_len(&self, len: usize) {
        self.len.store(len as u32, Ordering::Relaxed);
    }
}
