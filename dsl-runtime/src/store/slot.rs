//! Slots: pointers of a tree that are null until a block is made, once, by whichever thread comes first.

use super::sync::{AtomicPtr, Ordering, pause};

/// A pointer to a block. Zeroed memory is an empty slot.
#[repr(transparent)]
#[derive(Debug)]
pub(crate) struct Slot(AtomicPtr<u8>);

/// Stands in a slot while a thread makes its block: no block lies there.
const BUSY: usize = 1;

impl Slot {
    /// An empty slot.
    #[cfg(test)]
    #[allow(dead_code, reason = "the tests that model it make one")]
    pub(crate) fn empty() -> Self {
        Self(AtomicPtr::new(core::ptr::null_mut()))
    }

    /// The block; null where there is none, or where it is being made.
    #[inline(always)]
    pub(crate) fn get(&self) -> *mut u8 {
        // What was written to the block before it was put is seen by whoever gets it.
        let block = self.0.load(Ordering::Acquire);
        if block.addr() <= BUSY { core::ptr::null_mut() } else { block }
    }

    /// The block, made where there is none. `make` runs at most once for all threads; it must return, and not null.
    pub(crate) fn get_or_make(&self, make: impl FnOnce() -> *mut u8) -> *mut u8 {
        let mut block = self.0.load(Ordering::Acquire);
        loop {
            if block.addr() > BUSY {
                return block;
            }
            if block.is_null() {
                let busy = core::ptr::without_provenance_mut(BUSY);
                match self.0.compare_exchange(block, busy, Ordering::Acquire, Ordering::Acquire) {
                    Ok(_) => break,
                    Err(other) => block = other,
                }
            } else {
                pause();
                block = self.0.load(Ordering::Acquire);
            }
        }
        let block = make();
        debug_assert!(block.addr() > BUSY);
        self.0.store(block, Ordering::Release);
        block
    }

    /// Takes the block out. The caller has the tree to itself.
    pub(crate) fn take(&self) -> *mut u8 {
        let block = self.get();
        self.0.store(core::ptr::null_mut(), Ordering::Relaxed);
        block
    }
}
