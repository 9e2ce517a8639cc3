//! Blocks of sparse branches by their places: where [`Map`] meets a [`Store`].

use core::ops::Range;

use super::levels::{Block, Brick, Levels, ListSpec};
use super::node::Root;
use super::{Geometry, Inner, Layout, Map};
use crate::axes::{Axes, MAX_AXES, per_axis, sum};
use crate::field::parts::each_part_of;
use crate::record::Record;
use crate::store::active::ActiveList;
use crate::store::list::Head;
use crate::store::{Sizes, Store};

/// Puts cells in the order of their ranks. Sorting is much code: there is one copy of it for all layouts.
#[inline(never)]
fn in_rank(cells: &mut [Hashed]) {
    cells.sort_unstable_by_key(|cell| cell.rank);
}

/// A cell of a root that is a hash.
#[derive(Clone, Copy)]
struct Hashed {
    /// Its coordinates in the order of the root's axes.
    rank: Block,
    key: Block,
    cell: *mut u8,
}

// SAFETY: the address is that of a node which the store owns; who may touch it when is settled by the borrow of the field.
unsafe impl Sync for Hashed {}

/// The cells of a root.
struct Roots {
    /// In order, where they are found by hashing.
    hashed: Vec<Hashed>,
    count: usize,
}

/// The root's cells that a job looks through for active blocks.
const ROOTS: usize = 1 << 12;

impl<R: Record, L: Layout<X>, X: Axes> Map<R, L, X> {
    /// Whether the first branch is sparse.
    const SPARSE: bool = L::CHAIN.is_sparse();
    const GRAIN: usize = match &L::CHAIN.tree {
        Some(tree) => tree.grain,
        None => 0,
    };
    const HASHED: bool = matches!(&L::CHAIN.tree, Some(tree) if matches!(tree.root, Root::Hash));
    /// Blocks that a cell of the root spans.
    const SPAN: crate::axes::PerAxis = <L::Levels as Levels<X>>::SPAN;
    /// Bytes of a cell of the root.
    const CELL: usize = {
        let node = <L::Levels as Levels<X>>::BYTES;
        if node == 0 { Self::SIZES.brick } else { node }
    };
    pub(super) const SIZES: Sizes = {
        let (line, bits) = (Self::RUN_LINE, L::CHAIN.bits());
        let bits_at = super::place::round_up(Self::BLOCK_BYTES, 8);
        let brick = super::place::round_up(bits_at + bits.div_ceil(64) * 8, line);
        Sizes { line, brick, bits_at, bits, nodes: <L::Levels as Levels<X>>::SIZES }
    };

    /// Whether a member stands in a sparse branch.
    #[inline(always)]
    pub(crate) const fn is_sparse(m: usize) -> bool {
        Self::chain(m).is_sparse()
    }

    /// Whether any branch is sparse.
    pub(crate) const fn any_sparse() -> bool {
        Self::SPARSE || (L::BRANCHES > 1 && Map::<R, L::Rest, X>::any_sparse())
    }

    /// Whether the field has no extents.
    pub(crate) const fn is_unbounded() -> bool {
        Self::HASHED
    }

    /// The lists of the layout, if it has some.
    pub(crate) const fn list() -> Option<ListSpec> {
        <L::Levels as Levels<X>>::LIST
    }

    /// Where in the field's memory the address of the store of a member's branch stands.
    #[inline(always)]
    pub(crate) fn store_at(geometry: &Geometry, m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) {
            0
        } else {
            Self::rest_start(geometry).wrapping_add(Map::<R, L::Rest, X>::store_at(&geometry.rest::<L, X>(), m))
        }
    }

    /// Makes the stores of all sparse branches, each with where its address goes; `None` where the system refuses the memory.
    pub(crate) fn stores(geometry: &Geometry, at: usize, stores: &mut Vec<(usize, Box<Store>)>) -> Option<()> {
        if const { Self::SPARSE } {
            let cells = (!Self::HASHED).then(|| geometry.cells.checked_mul(Self::CELL));
            let cells = match cells {
                Some(bytes) => Some(bytes?),
                None => None,
            };
            stores.push((at, Store::new(Self::SIZES, cells)?));
        }
        if const { L::BRANCHES > 1 } {
            Map::<R, L::Rest, X>::stores(&geometry.rest::<L, X>(), at + Self::rest_start(geometry), stores)?;
        }
        Some(())
    }

    /// The root's cell that spans a block; null where there is none.
    #[inline(always)]
    fn root_cell(geometry: &Geometry, store: &Store, block: &Block) -> *mut u8 {
        match &store.hash {
            Some(hash) if Self::HASHED => hash.get(&Self::key(block)),
            _ => store.grid.wrapping_add(sum::<X>(
                #[inline(always)]
                |a| {
                    let cell = (block[a] / const { &Self::SPAN }[a] as u32) as usize;
                    let stride = if a == Self::FASTEST { 1 } else { geometry.stride[a] };
                    cell.wrapping_mul(stride).wrapping_mul(Self::CELL)
                },
            )),
        }
    }

    #[inline(always)]
    fn key(block: &Block) -> Block {
        per_axis(
            #[inline(always)]
            |a| block[a] / const { &Self::SPAN }[a] as u32,
        )
    }

    /// The block at a place within the field, of a member's branch; null where there is none.
    #[inline(always)]
    pub(crate) fn find(geometry: &Geometry, store: &Store, m: usize, block: &Block) -> *mut u8 {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::find(&geometry.rest::<L, X>(), store, m, block);
        }
        let cell = Self::root_cell(geometry, store, block);
        if Self::HASHED && cell.is_null() {
            return cell;
        }
        // SAFETY: a cell of the store's root is a node of the uppermost level.
        unsafe { <L::Levels as Levels<X>>::find(cell, block) }
    }

    /// The root's cell that spans a block, made where there is none.
    fn grown_cell(geometry: &Geometry, store: &Store, block: &Block) -> *mut u8 {
        match &store.hash {
            Some(hash) if Self::HASHED => {
                hash.get_or_make(&Self::key(block), || store.new_node(<L::Levels as Levels<X>>::BYTES, 0))
            }
            _ => Self::root_cell(geometry, store, block),
        }
    }

    /// The same, made where there is none.
    #[cold]
    #[inline(never)]
    pub(crate) fn grow(geometry: &Geometry, store: &Store, m: usize, block: &Block) -> *mut u8 {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::grow(&geometry.rest::<L, X>(), store, m, block);
        }
        let cell = Self::grown_cell(geometry, store, block);
        // SAFETY: a cell of the store's root is a node of the uppermost level.
        let brick = unsafe { <L::Levels as Levels<X>>::grow(cell, block, store, 0) };
        store.mark();
        brick
    }

    /// The list at a place within the field, made with the path to it if so asked.
    #[inline]
    pub(crate) fn head<'a, const GROW: bool>(geometry: &Geometry, store: &'a Store, block: &Block) -> Option<&'a Head> {
        let cell =
            if GROW { Self::grown_cell(geometry, store, block) } else { Self::root_cell(geometry, store, block) };
        if cell.is_null() {
            return None;
        }
        // SAFETY: a cell of the store's root is a node of the uppermost level.
        let head = unsafe { <L::Levels as Levels<X>>::head::<GROW>(cell, block, store, 0) };
        // SAFETY: null or a list of the store's, changed through shared references alone.
        unsafe { head.as_ref() }
    }

    /// The number of a cell of a block in memory order.
    #[inline(always)]
    pub(crate) fn cell_number(m: usize, inner: &[u32; MAX_AXES]) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::cell_number(m, inner);
        }
        sum::<X>(
            #[inline(always)]
            |a| <L::Inner as Inner<X>>::term(a, inner[a] as usize, L::CHAIN.leaf, 1),
        )
    }

    /// Cells that share one activity bit in a member's branch; 0 where a block is active as a whole.
    #[inline(always)]
    pub(crate) const fn grain(m: usize) -> usize {
        match &Self::chain(m).tree {
            Some(tree) => tree.grain,
            None => 0,
        }
    }

    /// Where the activity bits of a block begin.
    #[inline(always)]
    pub(crate) const fn bits_at(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) { Self::SIZES.bits_at } else { Map::<R, L::Rest, X>::bits_at(m) }
    }

    /// Visits all blocks of a member's branch that the store holds, in the order of the tree: where the root is a hash, in that of the
    /// blocks' coordinates.
    pub(crate) fn walk(geometry: &Geometry, store: &Store, m: usize, visit: &mut dyn FnMut(Brick)) {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::walk(&geometry.rest::<L, X>(), store, m, visit);
        }
        let roots = Self::roots(geometry, store);
        for (cell, first) in (0..roots.count).map(|n| Self::root(geometry, store, &roots, n)) {
            // SAFETY: a cell of the store's root is a node of the uppermost level, whose first block this is.
            unsafe { <L::Levels as Levels<X>>::walk(cell, first, visit) };
        }
    }

    /// The root's cells in order.
    fn roots(geometry: &Geometry, store: &Store) -> Roots {
        let Some(hash) = &store.hash else { return Roots { hashed: Vec::new(), count: geometry.cells } };
        let mut hashed = Vec::with_capacity(hash.len());
        hash.each(|key, cell| hashed.push(Hashed { rank: Self::ranked(key), key, cell }));
        in_rank(&mut hashed);
        Roots { count: hashed.len(), hashed }
    }

    /// One of them, with its first block.
    #[inline]
    fn root(geometry: &Geometry, store: &Store, roots: &Roots, n: usize) -> (*mut u8, Block) {
        let span = |at: Block| -> Block { per_axis(|a| at[a] * Self::SPAN[a] as u32) };
        if const { Self::HASHED } {
            let Hashed { key, cell, .. } = roots.hashed[n];
            return (cell, span(key));
        }
        let (axes, count) = const { super::order::<X>(L::CHAIN.root) };
        let (mut at, mut rest) = ([0; MAX_AXES], n);
        for &axis in axes[..count].iter().rev() {
            at[axis] = (rest % geometry.blocks[axis]) as u32;
            rest /= geometry.blocks[axis];
        }
        (store.grid.wrapping_add(n * Self::CELL), span(at))
    }

    /// Coordinates in the order of the root's axes, the first most significant.
    fn ranked(key: Block) -> Block {
        let (axes, count) = super::order::<X>(L::CHAIN.root);
        per_axis(|n| if n < count { key[axes[n]] } else { 0 })
    }

    /// Gives back the blocks of the first branch that `keep` does not keep, and pointers to nothing.
    pub(crate) fn sweep(geometry: &Geometry, store: &mut Store, keep: &mut dyn FnMut(Brick) -> bool) {
        let bytes = <L::Levels as Levels<X>>::BYTES;
        if let Some(hash) = &store.hash {
            let mut kept = |key: Block, cell: *mut u8| {
                let first = per_axis(|a| key[a] * Self::SPAN[a] as u32);
                // SAFETY: a cell of the store's root is a node of the uppermost level; `&mut` is exclusive.
                let empty = unsafe { <L::Levels as Levels<X>>::sweep(cell, first, store, 0, keep) };
                if empty {
                    store.give_node(cell, bytes, 0);
                }
                !empty
            };
            // SAFETY: `&mut` is exclusive.
            unsafe { hash.retain(&mut kept) };
        } else {
            let roots = Self::roots(geometry, store);
            for (cell, first) in (0..roots.count).map(|n| Self::root(geometry, store, &roots, n)) {
                // SAFETY: as above.
                let empty = unsafe { <L::Levels as Levels<X>>::sweep(cell, first, store, 0, keep) };
                if bytes == 0 && empty {
                    // A block of the root's own is there for good: it becomes as new.
                    // SAFETY: it has as many bytes as the template; `&mut` is exclusive.
                    unsafe { cell.copy_from_nonoverlapping(store.background, store.sizes.brick) };
                    store.mark();
                }
            }
        }
    }

    /// The number of a member's branch among the sparse ones.
    pub(crate) const fn sparse_branch(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) {
            0
        } else {
            Self::SPARSE as usize + Map::<R, L::Rest, X>::sparse_branch(m)
        }
    }

    /// Empties the sparse branches, whose stores these are.
    pub(crate) fn clear(geometry: &Geometry, stores: &mut dyn Iterator<Item = &mut Store>) {
        if const { Self::SPARSE } {
            let store = stores.next().expect("a store for each sparse branch");
            Self::sweep(geometry, store, &mut |_| false);
        }
        if const { L::BRANCHES > 1 } {
            Map::<R, L::Rest, X>::clear(&geometry.rest::<L, X>(), stores);
        }
    }

    /// Gives back the blocks that hold the background alone; of lists, those without entries.
    pub(crate) fn prune(geometry: &Geometry, stores: &mut dyn Iterator<Item = &mut Store>) {
        if const { Self::SPARSE } {
            let store = stores.next().expect("a store for each sparse branch");
            let (background, bytes) = (store.background, store.sizes.bits_at);
            // SAFETY: a block and the background have so many bytes, all initialised, and `&mut` is exclusive.
            let records = |start: *mut u8| unsafe { core::slice::from_raw_parts(start, bytes) };
            let is_list = Self::list().is_some();
            Self::sweep(geometry, store, &mut |brick| is_list || records(brick.start) != records(background));
        }
        if const { L::BRANCHES > 1 } {
            Map::<R, L::Rest, X>::prune(&geometry.rest::<L, X>(), stores);
        }
    }

    /// Gives back blocks of a member's branch without lists, which nobody uses any more.
    pub(crate) fn release(geometry: &Geometry, store: &Store, m: usize, blocks: &[Block]) {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::release(&geometry.rest::<L, X>(), store, m, blocks);
        }
        match &store.hash {
            Some(hash) if <L::Levels as Levels<X>>::BYTES == 0 => {
                let mut keys: Vec<Block> = blocks.iter().map(Self::key).collect();
                crate::index::sort(&mut keys);
                let mut kept = |key: Block, cell: *mut u8| {
                    let goes = keys.binary_search(&key).is_ok();
                    if goes {
                        store.give_node(cell, 0, 0);
                    }
                    !goes
                };
                // SAFETY: the caller has the field to itself.
                unsafe { hash.retain(&mut kept) };
            }
            _ => {
                for block in blocks {
                    let cell = Self::root_cell(geometry, store, block);
                    // SAFETY: a cell of the store's root is a node of the uppermost level; the caller has the field to itself.
                    unsafe { <L::Levels as Levels<X>>::release(cell, block, store, 0) };
                }
            }
        }
    }

    /// The active elements of a member's branch, looked for in parallel.
    pub(crate) fn active(geometry: &Geometry, store: &Store, m: usize) -> ActiveList {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::active(&geometry.rest::<L, X>(), store, m);
        }
        if const { !Self::SPARSE } {
            return ActiveList::default();
        }
        let roots = Self::roots(geometry, store);
        let noted =
            Noted { bits: L::CHAIN.bits(), bits_at: Self::SIZES.bits_at, grain: Self::GRAIN, cells: L::CHAIN.cells };
        noted.all(roots.count, &|part, list| {
            for n in part {
                let (cell, first) = Self::root(geometry, store, &roots, n);
                // SAFETY: a cell of the store's root is a node of the uppermost level, whose first block this is.
                unsafe { <L::Levels as Levels<X>>::walk(cell, first, &mut |brick| noted.put(&brick, list)) };
            }
        })
    }
}

/// What of a branch is to be known to tell its active elements: of each block, bits of activity, where they begin, cells that share one, and cells.
#[derive(Clone, Copy)]
struct Noted {
    bits: usize,
    bits_at: usize,
    grain: usize,
    cells: usize,
}

impl Noted {
    /// The active elements of a branch, whose root has so many cells: `walk` puts the blocks of some into a list.
    fn all(self, roots: usize, walk: &(dyn Fn(Range<usize>, &mut ActiveList) + Sync)) -> ActiveList {
        let empty = || ActiveList::new(self.bits.div_ceil(64));
        let mut parts = each_part_of(ROOTS, roots, |part| {
            let mut list = empty();
            walk(part, &mut list);
            list
        })
        .into_iter();
        let mut list = parts.next().unwrap_or_else(empty);
        parts.for_each(|part| list.append(&part));
        list
    }

    /// Adds a block to the active ones, if it has active elements.
    fn put(self, brick: &Brick, list: &mut ActiveList) {
        let work = if self.bits > 0 {
            let before = list.bits.len();
            let mut count = 0;
            for word in 0..list.words {
                let (bits, _) = Store::bit_of(brick.start, self.bits_at, word * 64);
                let bits = bits.load(core::sync::atomic::Ordering::Relaxed);
                count += bits.count_ones() as usize;
                list.bits.push(bits);
            }
            if count == 0 {
                list.bits.truncate(before);
            }
            count * self.grain
        } else {
            brick.entries.min(self.cells)
        };
        list.push(brick, work);
    }
}
