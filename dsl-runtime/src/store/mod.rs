//! What a sparse branch of a field holds: its root, the pools of its nodes, the background, and what loops need to know.
//!
//! Blocks are found from the root down without locks. Whoever needs a block that is not there makes it; see [`slot`] and [`hash`].
//! Blocks are given back when the field is borrowed exclusively, and at the end of a launch that has it to itself.

pub(crate) mod active;
pub(crate) mod hash;
pub(crate) mod list;
pub(crate) mod lock;
pub(crate) mod paths;
pub(crate) mod pool;
pub(crate) mod slot;

/// What slots, lists and the hash are made of: their tests model it.
mod sync {
    pub(super) use super::lock::Lock as Mutex;
    use super::lock::{Held, Lock};
    pub(super) use core::sync::atomic::{AtomicPtr, AtomicU32, AtomicUsize, Ordering};

    /// Into how many parts a hash is cut, each with a lock, and how many cells the first table of one has: powers of two.
    pub(super) const SHARDS: usize = 16;
    pub(super) const FIRST: usize = 16;

    pub(super) fn lock<T>(lock: &Lock<T>) -> Held<'_, T> {
        lock.lock()
    }

    /// Lets the thread that is making a block go on.
    pub(super) fn pause() {
        std::thread::yield_now();
    }

    /// A value that is read and written under rules of its own.
    #[derive(Debug)]
    pub(super) struct Shared<T>(core::cell::UnsafeCell<T>);

    impl<T: Copy> Shared<T> {
        pub(super) fn new(value: T) -> Self {
            Self(core::cell::UnsafeCell::new(value))
        }

        /// # Safety
        /// Nobody writes it meanwhile.
        #[inline(always)]
        pub(super) unsafe fn get(&self) -> T {
            // SAFETY: as the caller promises.
            unsafe { *self.0.get() }
        }

        /// # Safety
        /// Nobody reads or writes it meanwhile.
        pub(super) unsafe fn set(&self, value: T) {
            // SAFETY: as the caller promises.
            unsafe { *self.0.get() = value }
        }
    }
}

use core::sync::atomic::{AtomicBool, Ordering};

use crate::field::memory::{LINE, Memory};
use crate::layout::Block;
use active::Actives;
use hash::Hash;
use lock::Lock;
use pool::Pool;

/// The sizes of what a store holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes {
    /// What a block begins at a multiple of.
    pub(crate) line: usize,
    /// Bytes of a block with its activity bits: a multiple of `line`.
    pub(crate) brick: usize,
    /// Where the activity bits begin.
    pub(crate) bits_at: usize,
    /// How many there are; 0 where a block is active as a whole.
    pub(crate) bits: usize,
    /// Bytes of nodes that point, from the root's cells down; 0 ends the list.
    pub(crate) nodes: &'static [usize],
}

/// What a sparse branch of a field holds.
#[derive(Debug)]
#[doc(hidden)]
pub struct Store {
    /// The first of the root's cells, where they lie in a grid.
    pub(crate) grid: *mut u8,
    /// The root's cells, where they are found by hashing.
    pub(crate) hash: Option<Hash>,
    /// What reads of blocks that are not there read. Nothing writes it while it can be read.
    pub(crate) background: *mut u8,
    pub(crate) sizes: Sizes,
    memory: Memory,
    template: Memory,
    /// Whether the background is all zero bytes.
    blank: bool,
    tables: Vec<Pool>,
    bricks: Pool,
    /// Whether activity has changed since the list of active blocks was made.
    stale: AtomicBool,
    pub(crate) actives: Lock<Actives>,
    /// Elements that a loop has deactivated or removed.
    pub(crate) pending: Lock<Vec<Block>>,
}

// SAFETY: the addresses are those of memory that the store owns; who may touch it when is settled by the borrow of the field and
// by the rules of slots.
unsafe impl Send for Store {}
// SAFETY: as above.
unsafe impl Sync for Store {}

impl Store {
    /// A store whose root has so many cells of so many bytes, or is a hash; `None` where the system refuses the memory.
    pub(crate) fn new(sizes: Sizes, grid: Option<usize>) -> Option<Box<Self>> {
        let memory = Memory::zeroed(grid.unwrap_or(0), sizes.line)?;
        let template = Memory::zeroed(sizes.brick, sizes.line)?;
        let rounded = |bytes: usize| bytes.next_multiple_of(LINE);
        Some(Box::new(Self {
            grid: memory.start(),
            hash: grid.is_none().then(Hash::new),
            background: template.start(),
            sizes,
            memory,
            template,
            blank: true,
            tables: sizes
                .nodes
                .iter()
                .filter(|&&bytes| bytes > 0)
                .map(|&bytes| Pool::new(rounded(bytes), LINE))
                .collect(),
            bricks: Pool::new(sizes.brick, sizes.line),
            stale: AtomicBool::new(true),
            actives: Lock::default(),
            pending: Lock::default(),
        }))
    }

    /// A new node of the level at a depth: pointers of so many bytes, or a block where that is 0.
    #[cold]
    pub(crate) fn new_node(&self, bytes: usize, depth: usize) -> *mut u8 {
        if bytes == 0 {
            return self.new_brick();
        }
        let fresh = self.tables[depth].take();
        if !fresh.zero {
            // SAFETY: the pool's blocks have so many bytes, and this one is ours.
            unsafe { fresh.start.write_bytes(0, bytes) };
        }
        fresh.start
    }

    /// A new block, full of the background, with no active cell.
    fn new_brick(&self) -> *mut u8 {
        let fresh = self.bricks.take();
        if !(fresh.zero && self.blank) {
            // SAFETY: the pool's blocks are as large as the template, and this one is ours.
            unsafe { fresh.start.copy_from_nonoverlapping(self.background, self.sizes.brick) };
        }
        fresh.start
    }

    /// Takes back a node whose pointers, or a block whose records, nobody uses any more.
    pub(crate) fn give_node(&self, node: *mut u8, bytes: usize, depth: usize) {
        self.mark();
        let pool = if bytes == 0 { &self.bricks } else { &self.tables[depth] };
        pool.give(node);
    }

    /// Notes that activity has changed: after the change, lest a list that is being made miss both.
    #[inline(always)]
    pub(crate) fn mark(&self) {
        // Read first: a line that many threads write would go from one to the other.
        if !self.stale.load(Ordering::Relaxed) {
            self.stale.store(true, Ordering::Relaxed);
        }
    }

    /// Whether activity has changed since this was last asked.
    pub(crate) fn take_mark(&self) -> bool {
        self.stale.swap(false, Ordering::Relaxed)
    }

    /// Changes the background. The caller fills the blocks that are there.
    pub(crate) fn set_background(&mut self, write: impl FnOnce(*mut u8)) {
        write(self.background);
        self.blank = self.template.as_slice().iter().all(|&byte| byte == 0);
    }

    /// The word of a block that holds an activity bit, and the bit in it.
    #[inline(always)]
    pub(crate) fn bit_of<'a>(brick: *mut u8, bits_at: usize, bit: usize) -> (&'a core::sync::atomic::AtomicU64, u64) {
        let word = brick.wrapping_add(bits_at + bit / 64 * 8);
        // SAFETY: callers give blocks of a store with such bits, whose words are changed through shared references alone.
        (unsafe { &*word.cast::<core::sync::atomic::AtomicU64>() }, 1 << (bit % 64))
    }

    /// Bytes of the root, the nodes and the blocks.
    pub(crate) fn bytes(&self) -> usize {
        let tables: usize = self.tables.iter().map(Pool::bytes).sum();
        self.memory.bytes() + tables + self.bricks.bytes() + self.hash.as_ref().map_or(0, Hash::bytes)
    }

    /// Frees old lists and tables, which no loop can be using.
    pub(crate) fn settle(&mut self) {
        self.actives.get_mut().older.clear();
        if let Some(hash) = &mut self.hash {
            hash.settle();
        }
    }

    /// Gives slabs back to the system of which no block is in use, and tables without one.
    pub(crate) fn shrink(&mut self) {
        self.hash.as_mut().into_iter().for_each(Hash::shrink);
        self.tables.iter_mut().for_each(Pool::shrink);
        self.bricks.shrink();
    }
}
