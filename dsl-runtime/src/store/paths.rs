//! The blocks that a job has found last, so that neighbours are looked up once a block and not once a cell.

use core::cell::UnsafeCell;
use core::mem::MaybeUninit;

use crate::layout::Block;

/// A block that was found, or the background where there was none.
#[derive(Clone, Copy, Debug)]
struct Found {
    block: Block,
    branch: u32,
    start: *mut u8,
}

/// How many blocks are remembered: of three axes, four along each, so that a block and its neighbours have places of their own.
const PLACES: usize = 64;

/// More than any field has of branches.
const NOBODY: u32 = u32::MAX;

/// A job's own memory of the blocks of one field that it has found. One that is not asked is not initialised.
#[doc(hidden)]
pub struct Paths(UnsafeCell<MaybeUninit<Seen>>);

type Seen = [Found; PLACES];

impl core::fmt::Debug for Paths {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Paths")
    }
}

impl Paths {
    /// A memory that is never asked.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self(UnsafeCell::new(MaybeUninit::uninit()))
    }

    /// A memory of nothing.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        let nothing = Found { block: [0; 4], branch: NOBODY, start: core::ptr::null_mut() };
        Self(UnsafeCell::new(MaybeUninit::new([nothing; PLACES])))
    }

    /// The place of a block, in which another may stand.
    #[inline(always)]
    fn place(block: &Block, branch: u32) -> usize {
        let low = |a: usize| (block[a] & 3) as usize;
        (low(0) | low(1) << 2 | low(2) << 4) ^ low(3) ^ (branch as usize % PLACES)
    }

    /// What is remembered.
    ///
    /// # Safety
    /// This is a memory made by [`new`](Self::new), of the thread that calls, which holds no other reference to it.
    #[inline(always)]
    #[allow(clippy::mut_from_ref, reason = "the caller has it to itself")]
    unsafe fn seen(&self) -> &mut Seen {
        // SAFETY: as the caller promises.
        unsafe { (*self.0.get()).assume_init_mut() }
    }

    /// A block of a branch: as it was found last, or by `find`.
    ///
    /// # Safety
    /// This is a memory made by [`new`](Self::new), and of the thread that calls.
    #[inline(always)]
    pub(crate) unsafe fn get(&self, block: &Block, branch: u32, find: impl FnOnce() -> *mut u8) -> *mut u8 {
        // SAFETY: as the caller promises; `find` does not reach this memory.
        let found = unsafe { &mut self.seen()[Self::place(block, branch)] };
        if found.block != *block || found.branch != branch {
            *found = Found { block: *block, branch, start: find() };
        }
        found.start
    }

    /// Remembers a block that was made.
    ///
    /// # Safety
    /// As for [`get`](Self::get).
    #[inline(always)]
    pub(crate) unsafe fn put(&self, block: &Block, branch: u32, start: *mut u8) {
        // SAFETY: as the caller promises.
        let found = unsafe { &mut self.seen()[Self::place(block, branch)] };
        *found = Found { block: *block, branch, start };
    }
}
