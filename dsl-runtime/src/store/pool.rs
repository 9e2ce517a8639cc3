//! Pools: blocks of one size, cut from slabs, reused when they are given back.

use super::lock::Lock;
use crate::field::memory::Memory;

/// Blocks of one size. Each begins at a multiple of the alignment.
#[derive(Debug)]
pub(crate) struct Pool {
    bytes: usize,
    align: usize,
    state: Lock<State>,
}

#[derive(Debug, Default)]
struct State {
    slabs: Vec<Memory>,
    /// Blocks that were given back.
    free: Vec<usize>,
    /// Blocks of the last slab that nobody has had, and how many it has.
    next: usize,
    last: usize,
    /// Blocks of all slabs.
    blocks: usize,
}

/// The fewest bytes of a slab, where a block is not larger.
const SMALLEST: usize = 1 << 12;
/// What slabs grow to.
const LARGEST: usize = 1 << 20;
/// A new slab is at most this part of what there is, so that little lies idle.
const PART: usize = 32;

/// A block from a pool.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fresh {
    pub(crate) start: *mut u8,
    /// Whether all of its bytes are zero, since nobody has had it.
    pub(crate) zero: bool,
}

impl Pool {
    /// A pool of blocks of so many bytes, a multiple of the alignment.
    pub(crate) fn new(bytes: usize, align: usize) -> Self {
        assert!(bytes > 0 && bytes.is_multiple_of(align));
        Self { bytes, align, state: Lock::default() }
    }

    /// A block that is nobody else's. Where the system refuses memory, the program ends.
    pub(crate) fn take(&self) -> Fresh {
        let mut state = self.state.lock();
        if let Some(start) = state.free.pop() {
            // Addresses are kept as numbers so that the pool is `Send`; their slab has exposed its provenance.
            return Fresh { start: core::ptr::with_exposed_provenance_mut(start), zero: false };
        }
        if state.next == state.last {
            let bytes = (state.blocks * self.bytes / PART).clamp(SMALLEST, LARGEST);
            let blocks = (bytes / self.bytes).max(1);
            let slab = Memory::zeroed_or_abort(blocks * self.bytes, self.align);
            slab.start().expose_provenance();
            state.slabs.push(slab);
            (state.next, state.last) = (0, blocks);
            state.blocks += blocks;
        }
        let slab = state.slabs.last().expect("a slab was just made, or has blocks left");
        let start = slab.start().wrapping_add(state.next * self.bytes);
        state.next += 1;
        Fresh { start, zero: true }
    }

    /// Takes back a block that nobody uses any more.
    pub(crate) fn give(&self, start: *mut u8) {
        self.state.lock().free.push(start.expose_provenance());
    }

    /// Gives the slabs back to the system where no block is in use.
    pub(crate) fn shrink(&mut self) {
        let state = self.state.get_mut();
        if state.free.len() == state.blocks - (state.last - state.next) {
            *state = State::default();
        }
    }

    /// Bytes of all slabs.
    pub(crate) fn bytes(&self) -> usize {
        self.state.lock().blocks * self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_apart_aligned_and_reused() {
        let mut pool = Pool::new(192, 64);
        let mut blocks: Vec<*mut u8> = (0..500).map(|_| pool.take()).map(|fresh| fresh.start).collect();
        assert!(blocks.iter().all(|block| block.addr().is_multiple_of(64)));
        blocks.sort_unstable();
        assert!(blocks.windows(2).all(|pair| pair[1].addr() - pair[0].addr() >= 192));
        let bytes = pool.bytes();
        assert!(bytes < 500 * 192 + 500 * 192 / PART + 2 * SMALLEST);
        for _ in 0..10 {
            blocks.drain(..).for_each(|block| pool.give(block));
            blocks.extend((0..500).map(|_| pool.take()).inspect(|fresh| assert!(!fresh.zero)).map(|fresh| fresh.start));
        }
        assert_eq!(pool.bytes(), bytes);
        pool.shrink();
        assert_eq!(pool.bytes(), bytes, "blocks are in use");
        blocks.drain(..).for_each(|block| pool.give(block));
        pool.shrink();
        assert_eq!(pool.bytes(), 0);
    }
}
