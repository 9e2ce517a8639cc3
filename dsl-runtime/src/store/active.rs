//! The list of active blocks: made when a loop needs it, kept until activity changes.

use std::sync::Arc;

use crate::axes::MAX_AXES;
use crate::layout::{Block, Brick};

/// The active elements of a branch at one time, block by block in memory order.
#[derive(Debug, Default)]
pub(crate) struct ActiveList {
    pub(crate) bricks: Vec<ActiveBrick>,
    /// For each block, what is to be done in it and in those before: elements, as they share activity bits.
    pub(crate) ends: Vec<usize>,
    /// The activity bits of all blocks, where they have some.
    pub(crate) bits: Vec<u64>,
    /// Words of one block's.
    pub(crate) words: usize,
    /// The blocks' box: the first and the one after the last along each axis.
    pub(crate) first: [u64; MAX_AXES],
    pub(crate) end: [u64; MAX_AXES],
}

/// A block with active cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ActiveBrick {
    pub(crate) start: *mut u8,
    pub(crate) block: Block,
}

// SAFETY: the addresses are those of blocks that the store owns; who may touch them when is settled by the borrow of the field.
unsafe impl Send for ActiveBrick {}
// SAFETY: as above.
unsafe impl Sync for ActiveBrick {}

/// The newest list of active blocks, and older ones that a running loop may be using.
#[derive(Debug, Default)]
pub(crate) struct Actives {
    pub(crate) newest: Option<Arc<ActiveList>>,
    pub(crate) older: Vec<Arc<ActiveList>>,
    /// How many threads are making a new list: until they have, the newest is not new enough.
    pub(crate) making: usize,
}

impl ActiveList {
    /// An empty list of blocks with so many words of activity bits.
    pub(crate) fn new(words: usize) -> Self {
        Self { words, first: [u64::MAX; MAX_AXES], ..Self::default() }
    }

    /// Adds a block with so many elements to visit, if there are any.
    pub(crate) fn push(&mut self, brick: &Brick, work: usize) {
        if work == 0 {
            return;
        }
        self.bricks.push(ActiveBrick { start: brick.start, block: brick.block });
        self.ends.push(self.work() + work);
        for (a, &b) in brick.block.iter().enumerate() {
            self.first[a] = self.first[a].min(b.into());
            self.end[a] = self.end[a].max(u64::from(b) + 1);
        }
    }

    /// Adds what another list holds behind what this one does.
    pub(crate) fn append(&mut self, other: &Self) {
        let before = self.work();
        self.bricks.extend_from_slice(&other.bricks);
        self.ends.extend(other.ends.iter().map(|end| before + end));
        self.bits.extend_from_slice(&other.bits);
        for a in 0..MAX_AXES {
            self.first[a] = self.first[a].min(other.first[a]);
            self.end[a] = self.end[a].max(other.end[a]);
        }
    }

    /// All that is to be done.
    pub(crate) fn work(&self) -> usize {
        self.ends.last().copied().unwrap_or(0)
    }

    /// What is to be done before block `n`.
    #[inline(always)]
    pub(crate) fn start(&self, n: usize) -> usize {
        if n == 0 { 0 } else { self.ends[n - 1] }
    }

    /// The activity bits of block `n`.
    #[inline(always)]
    pub(crate) fn bits(&self, n: usize) -> &[u64] {
        &self.bits[n * self.words..(n + 1) * self.words]
    }
}

/// The first bit from `from` to before `end` that is `set`; `end` where there is none.
#[inline(always)]
pub(crate) fn next_bit(bits: &[u64], from: usize, end: usize, set: bool) -> usize {
    let mut at = from;
    while at < end {
        let word = if set { bits[at / 64] } else { !bits[at / 64] } >> (at % 64);
        if word != 0 {
            return (at + word.trailing_zeros() as usize).min(end);
        }
        at = (at / 64 + 1) * 64;
    }
    end
}

#[cfg(test)]
mod tests {
    use super::next_bit;

    #[test]
    fn runs_of_bits() {
        let bits = [0x8000_0000_0000_0006u64, 0x1, 0];
        assert_eq!(next_bit(&bits, 0, 192, true), 1);
        assert_eq!(next_bit(&bits, 1, 192, false), 3);
        assert_eq!(next_bit(&bits, 3, 192, true), 63);
        assert_eq!(next_bit(&bits, 63, 192, false), 65);
        assert_eq!(next_bit(&bits, 65, 192, true), 192);
        assert_eq!(next_bit(&bits, 3, 40, true), 40);
    }
}
