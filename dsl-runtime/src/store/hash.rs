//! The root of an unbounded field: blocks found by hashing their coordinates.
//!
//! Lookups take no lock. Whoever makes a block holds the lock of its shard. A table that has become too small is replaced by a larger
//! one with the same entries and kept until nobody can be reading it; blocks never move.

use super::sync::{AtomicPtr, AtomicUsize, FIRST, Mutex, Ordering, SHARDS, Shared, lock};
use crate::axes::MAX_AXES;

/// Coordinates of one of the root's cells.
pub(crate) type Key = [u32; MAX_AXES];

/// A table of blocks by their coordinates.
#[derive(Debug)]
pub(crate) struct Hash {
    shards: Box<[Shard]>,
    /// How many tables have been replaced since the last [`Hash::settle`].
    replaced: AtomicUsize,
}

#[derive(Debug)]
struct Shard {
    /// The newest table, for lookups; null before the first.
    table: AtomicPtr<Table>,
    count: AtomicUsize,
    /// All tables since the last [`Hash::settle`], the newest last. The lock is held to change the shard.
    tables: Mutex<Vec<*mut Table>>,
}

// SAFETY: tables are reached under the rules below, and freed by whoever has the shard to itself.
unsafe impl Send for Shard {}
// SAFETY: as above.
unsafe impl Sync for Shard {}

#[derive(Debug)]
struct Table {
    cells: Box<[Cell]>,
}

/// An entry. Its key is written before its block is put, and never again.
#[derive(Debug)]
struct Cell {
    key: Shared<Key>,
    block: AtomicPtr<u8>,
}

/// Mixes coordinates: neighbours go far apart.
#[inline(always)]
fn mixed(key: &Key) -> usize {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let ([i, j, k, l], wide) = (*key, u64::from);
    let (i, j, k, l) = (wide(i), wide(j), wide(k), wide(l));
    let mut mixed = (i ^ (j << 32)).wrapping_mul(FACTOR);
    mixed = (mixed ^ (mixed >> 29) ^ k ^ (l << 32)).wrapping_mul(FACTOR);
    (mixed ^ (mixed >> 32)) as usize
}

impl Table {
    fn new(size: usize) -> *mut Self {
        let cell = || Cell { key: Shared::new([0; MAX_AXES]), block: AtomicPtr::new(core::ptr::null_mut()) };
        Box::into_raw(Box::new(Self { cells: (0..size).map(|_| cell()).collect() }))
    }

    /// The cell of a key, or the empty one where it would stand. There always is one: tables are never full.
    #[inline(always)]
    fn cell(&self, key: &Key, mixed: usize) -> (&Cell, *mut u8) {
        let mask = self.cells.len() - 1;
        let mut n = mixed & mask;
        loop {
            let cell = &self.cells[n];
            let block = cell.block.load(Ordering::Acquire);
            // SAFETY: the key was written before the block was put, which has been seen, and is not written again.
            if block.is_null() || unsafe { cell.key.get() } == *key {
                return (cell, block);
            }
            n = (n + 1) & mask;
        }
    }

    /// Puts a block under a key that has none.
    ///
    /// # Safety
    /// The caller holds the shard's lock.
    unsafe fn put(&self, key: &Key, block: *mut u8) {
        let (cell, _) = self.cell(key, mixed(key) / SHARDS);
        // SAFETY: nobody reads the key of a cell without a block, and the lock keeps other writers away.
        unsafe { cell.key.set(*key) };
        cell.block.store(block, Ordering::Release);
    }
}

impl Hash {
    /// A table without blocks.
    pub(crate) fn new() -> Self {
        let shard = |_| Shard {
            table: AtomicPtr::new(core::ptr::null_mut()),
            count: AtomicUsize::new(0),
            tables: Mutex::new(Vec::new()),
        };
        Self { shards: (0..SHARDS).map(shard).collect(), replaced: AtomicUsize::new(0) }
    }

    /// The block of a key; null where there is none.
    #[inline(always)]
    pub(crate) fn get(&self, key: &Key) -> *mut u8 {
        let mixed = mixed(key);
        let table = self.shards[mixed % SHARDS].table.load(Ordering::Acquire);
        if table.is_null() {
            return table.cast();
        }
        // SAFETY: a table lives until the field is borrowed exclusively, when nobody looks anything up.
        unsafe { &*table }.cell(key, mixed / SHARDS).1
    }

    /// The block of a key, made where there is none, once for all threads.
    pub(crate) fn get_or_make(&self, key: &Key, make: impl FnOnce() -> *mut u8) -> *mut u8 {
        let shard = &self.shards[mixed(key) % SHARDS];
        let mut tables = lock(&shard.tables);
        let known = self.get(key);
        if !known.is_null() {
            return known;
        }
        let block = make();
        let before = tables.len();
        // SAFETY: the lock is held; every table in the list lives.
        unsafe { shard.insert(&mut tables, key, block) };
        if tables.len() > before.max(1) {
            self.replaced.fetch_add(1, Ordering::Relaxed);
        }
        block
    }

    /// Calls `visit` with every key and block, in no order.
    pub(crate) fn each(&self, mut visit: impl FnMut(Key, *mut u8)) {
        for shard in &self.shards {
            let tables = lock(&shard.tables);
            let Some(&table) = tables.last() else { continue };
            // SAFETY: tables in the list live while the lock is held.
            for cell in &unsafe { &*table }.cells {
                let block = cell.block.load(Ordering::Acquire);
                if !block.is_null() {
                    // SAFETY: as in `Table::cell`.
                    visit(unsafe { cell.key.get() }, block);
                }
            }
        }
    }

    /// Blocks in all.
    pub(crate) fn len(&self) -> usize {
        self.shards.iter().map(|shard| shard.count.load(Ordering::Relaxed)).sum()
    }

    /// Frees the tables that have been replaced. The caller has the field to itself.
    pub(crate) fn settle(&mut self) {
        if self.replaced.load(Ordering::Relaxed) == 0 {
            return;
        }
        self.replaced.store(0, Ordering::Relaxed);
        for shard in &self.shards {
            let mut tables = lock(&shard.tables);
            let replaced = tables.len().saturating_sub(1);
            for table in tables.drain(..replaced) {
                // SAFETY: made by `Box::into_raw`, in the list once, and nobody's any more.
                drop(unsafe { Box::from_raw(table) });
            }
        }
    }

    /// Takes out the blocks that `keep` does not keep.
    ///
    /// # Safety
    /// Nobody else looks anything up meanwhile.
    pub(crate) unsafe fn retain(&self, keep: &mut dyn FnMut(Key, *mut u8) -> bool) {
        for shard in &self.shards {
            let mut kept = Vec::new();
            let before = shard.count.load(Ordering::Relaxed);
            let mut tables = lock(&shard.tables);
            if let Some(&table) = tables.last() {
                // SAFETY: tables in the list live.
                for cell in &unsafe { &*table }.cells {
                    let block = cell.block.load(Ordering::Acquire);
                    // SAFETY: as in `Table::cell`.
                    let key = unsafe { cell.key.get() };
                    if !block.is_null() && keep(key, block) {
                        kept.push((key, block));
                    }
                }
            }
            if kept.len() == before && before > 0 {
                continue;
            }
            // SAFETY: as the caller promises, nobody else reaches the tables.
            unsafe { if kept.is_empty() { shard.empty(&mut tables, before) } else { shard.clear(&mut tables) } };
            for (key, block) in kept {
                // SAFETY: the lock is held.
                unsafe { shard.insert(&mut tables, &key, block) };
            }
        }
    }

    /// Frees the tables without a block.
    pub(crate) fn shrink(&mut self) {
        for shard in self.shards.iter().filter(|shard| shard.count.load(Ordering::Relaxed) == 0) {
            // SAFETY: `&mut` is exclusive.
            unsafe { shard.clear(&mut lock(&shard.tables)) };
        }
    }

    /// Bytes of the tables.
    pub(crate) fn bytes(&self) -> usize {
        let bytes = |shard: &Shard| -> usize {
            // SAFETY: tables in the list live while the lock is held.
            lock(&shard.tables).iter().map(|&table| size_of_val(&*unsafe { &*table }.cells)).sum()
        };
        self.shards.iter().map(bytes).sum()
    }
}

impl Shard {
    /// Puts a block under a key that has none, into a table that is never more than half full.
    ///
    /// # Safety
    /// The caller holds the lock, whose list this is.
    unsafe fn insert(&self, tables: &mut Vec<*mut Table>, key: &Key, block: *mut u8) {
        let count = self.count.load(Ordering::Relaxed) + 1;
        // SAFETY: tables in the list live.
        let newest = tables.last().map(|&table| unsafe { &*table });
        let table = match newest {
            Some(table) if 2 * count <= table.cells.len() => table,
            old => {
                let larger =
                    Table::new(old.map_or(FIRST, |table| 2 * table.cells.len()).max(2 * count.next_power_of_two()));
                // SAFETY: just made.
                let larger_table = unsafe { &*larger };
                for cell in old.iter().flat_map(|table| &table.cells) {
                    let block = cell.block.load(Ordering::Acquire);
                    if !block.is_null() {
                        // SAFETY: as in `Table::cell`; the lock is held.
                        unsafe { larger_table.put(&cell.key.get(), block) };
                    }
                }
                tables.push(larger);
                self.table.store(larger, Ordering::Release);
                larger_table
            }
        };
        // SAFETY: the lock is held.
        unsafe { table.put(key, block) };
        self.count.store(count, Ordering::Relaxed);
    }

    /// Takes all blocks out. The newest table stays if it is not far too large for as many as it held before: a field that is cleared
    /// in every step soon holds as many again.
    ///
    /// # Safety
    /// Nobody else reaches the tables.
    unsafe fn empty(&self, tables: &mut Vec<*mut Table>, before: usize) {
        // SAFETY: tables in the list live.
        let newest = tables.pop_if(|table| unsafe { &**table }.cells.len() <= 8 * before);
        // SAFETY: as the caller promises.
        unsafe { self.clear(tables) };
        let Some(newest) = newest else { return };
        // SAFETY: it has just been in the list.
        unsafe { &*newest }.cells.iter().for_each(|cell| cell.block.store(core::ptr::null_mut(), Ordering::Relaxed));
        tables.push(newest);
        self.table.store(newest, Ordering::Relaxed);
    }

    /// Frees all tables.
    ///
    /// # Safety
    /// Nobody else reaches them.
    unsafe fn clear(&self, tables: &mut Vec<*mut Table>) {
        self.table.store(core::ptr::null_mut(), Ordering::Relaxed);
        self.count.store(0, Ordering::Relaxed);
        for table in tables.drain(..) {
            // SAFETY: made by `Box::into_raw`, in the list once, and nobody's any more.
            drop(unsafe { Box::from_raw(table) });
        }
    }
}

impl Drop for Shard {
    fn drop(&mut self) {
        let mut tables = core::mem::take(&mut *lock(&self.tables));
        // SAFETY: a shard that is dropped is reached by nobody.
        unsafe { self.clear(&mut tables) };
    }
}
