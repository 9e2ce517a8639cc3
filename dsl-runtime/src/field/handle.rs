//! A field's address and geometry: how values of any path are reached, whatever the layout.

use core::marker::PhantomData;
use core::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use super::storage::Storage;
use crate::axes::{Axes, MAX_AXES, per_axis, sum};
use crate::index::{IntoIndex, within};
use crate::layout::{Block, Geometry, Layout, Map};
use crate::probe::Region;
use crate::record::{Path, Record};
use crate::store::Store;
use crate::store::active::ActiveList;
use crate::store::paths::Paths;
use crate::view::{Around, Corners};

/// A field's address and geometry, which views copy. What may be done through it is its maker's promise.
#[doc(hidden)]
pub struct Handle<'a, R, L, X> {
    pub(crate) root: *mut u8,
    pub(crate) geometry: Geometry,
    /// Where private copies of the field are kept between launches; nowhere for memory that is no field's.
    pub(crate) spare: Option<&'a Mutex<Vec<Storage>>>,
    /// The blocks of sparse branches that this job has found; null outside of jobs.
    paths: *const Paths,
    /// Told apart in these: the blocks of the field itself, 0, and those of a job's own copy.
    copy: u32,
    /// Whether its maker holds the whole field's `&mut`, rather than that of a member.
    pub(crate) exclusive: bool,
    marker: PhantomData<(R, L, X)>,
}

/// More than any layout has branches.
const COPY: u32 = 8;

impl<R, L, X> Clone for Handle<'_, R, L, X> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X> Copy for Handle<'_, R, L, X> {}

// SAFETY: a handle is an address; every read or write through it is justified where it is made, by the borrow of the
// field (host views) or by the launch's rules (kernel views). Views of jobs, which have paths, are not `Send`.
unsafe impl<R, L, X> Send for Handle<'_, R, L, X> {}
// SAFETY: as above.
unsafe impl<R, L, X> Sync for Handle<'_, R, L, X> {}

impl<'a, R, L, X> Handle<'a, R, L, X> {
    /// The handle of a field's storage.
    #[inline(always)]
    pub(crate) fn new(
        root: *mut u8,
        geometry: Geometry,
        spare: Option<&'a Mutex<Vec<Storage>>>,
        exclusive: bool,
    ) -> Self {
        Self { root, geometry, spare, paths: core::ptr::null(), copy: 0, exclusive, marker: PhantomData }
    }

    /// A handle for the elements of a slice.
    #[inline]
    pub(crate) fn of_slice(root: *mut u8, geometry: Geometry) -> Self {
        Self::new(root, geometry, None, true)
    }

    /// The same with a job's memory of blocks.
    ///
    /// # Safety
    /// The memory outlives every use of the handle, which stays on this thread.
    #[inline(always)]
    pub(crate) unsafe fn with_paths(self, paths: *const Paths) -> Self {
        Self { paths, ..self }
    }

    /// The same without such a memory: for whoever may be on another thread.
    #[inline(always)]
    pub(crate) fn without_paths(self) -> Self {
        Self { paths: core::ptr::null(), ..self }
    }

    /// The same geometry at another address, where as many bytes lie.
    #[inline(always)]
    pub(crate) fn at(self, root: *mut u8) -> Self {
        Self { root, copy: if core::ptr::eq(root, self.root) { self.copy } else { COPY }, ..self }
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Handle<'_, R, L, X> {
    /// A memory of blocks for a job.
    #[inline(always)]
    pub(crate) fn paths(&self) -> Paths {
        if const { Map::<R, L, X>::any_sparse() } { Paths::new() } else { Paths::none() }
    }

    /// The bytes of a field whose layout is dense, or of a slice, which ends with its last element.
    #[inline(always)]
    pub(crate) fn dense_bytes(&self) -> usize {
        if const { Map::<R, L, X>::is_one_run() } {
            return self.geometry.cells * const { Map::<R, L, X>::run_item() };
        }
        Map::<R, L, X>::bytes(&self.geometry).expect("the field has been allocated")
    }

    /// What holds the blocks of a member's branch.
    #[inline(always)]
    pub(crate) fn store(&self, m: usize) -> &Store {
        assert!(Map::<R, L, X>::is_sparse(m));
        let at = self.root.wrapping_add(Map::<R, L, X>::store_at(&self.geometry, m));
        // SAFETY: there the storage has put the address of the branch's store, which it owns; the handle's maker keeps it alive.
        unsafe { &**at.cast::<*const Store>() }
    }

    /// The block of an element of a sparse branch, and the element's place in it.
    #[inline(always)]
    pub(crate) fn split(m: usize, at: [u32; MAX_AXES]) -> (Block, [u32; MAX_AXES]) {
        let extent = |a: usize| Map::<R, L, X>::chain(m).extent[a] as u32;
        (
            per_axis(
                #[inline(always)]
                |a| at[a] / extent(a),
            ),
            per_axis(
                #[inline(always)]
                |a| at[a] % extent(a),
            ),
        )
    }

    /// A block of a sparse branch; where there is none, the background's.
    #[inline(always)]
    pub(crate) fn brick(&self, m: usize, block: &Block) -> *mut u8 {
        // Copies: what a call could reach would have to stay in memory, with all that it is a part of.
        let (this, at) = (*self, *block);
        if self.paths.is_null() {
            return this.find(m, at);
        }
        // SAFETY: whoever gave the handle paths keeps them alive and on this thread.
        unsafe {
            (*self.paths).get(
                block,
                self.copy + Map::<R, L, X>::branch(m) as u32,
                #[inline(always)]
                move || this.find(m, at),
            )
        }
    }

    #[inline(never)]
    fn find(self, m: usize, block: Block) -> *mut u8 {
        let store = self.store(m);
        let found = Map::<R, L, X>::find(&self.geometry, store, m, &block);
        if found.is_null() { store.background } else { found }
    }

    /// The set of the blocks that follow `first` by none or one along each of up to three axes; for those that lie beyond the field, the background.
    #[inline(always)]
    pub(crate) fn around(&self, corners: &L::Corners, first: Block) -> usize {
        // A copy, as in `brick`.
        let this = *self;
        corners.seek(&first, move || this.find_around(first))
    }

    #[cold]
    #[inline(never)]
    fn find_around(self, first: Block) -> Around {
        let store = self.store(0);
        let mut around = Around { blocks: [store.background; 8], there: 0 };
        for (corner, known) in around.blocks.iter_mut().enumerate().take(const { 1 << X::RANK }) {
            let Some(block) = self.beside(first, corner) else { continue };
            let found = Map::<R, L, X>::find(&self.geometry, store, 0, &block);
            if !found.is_null() {
                *known = found;
                around.there |= 1 << corner;
            }
        }
        around
    }

    /// The block beside another along the axes of a corner; nothing where it lies beyond the field.
    fn beside(&self, first: Block, corner: usize) -> Option<Block> {
        let mut block = first;
        for axis in (0..X::RANK).filter(|axis| corner >> axis & 1 == 1) {
            block[axis] = first[axis].checked_add(1)?;
            let begins = u64::from(block[axis]) * Map::<R, L, X>::chain(0).extent[axis] as u64;
            if begins >= u64::from(self.geometry.shape[axis]) {
                return None;
            }
        }
        Some(block)
    }

    /// Makes those blocks around `first` that are missing, a bit each.
    #[inline(always)]
    pub(crate) fn grow_around(&self, corners: &L::Corners, set: usize, first: Block, missing: u8) {
        // Copies, as in `brick`.
        corners.renew(set, Self::grow_around_cold(*self, first, missing));
    }

    #[cold]
    #[inline(never)]
    fn grow_around_cold(self, first: Block, missing: u8) -> Around {
        for corner in (0..8).filter(|corner| missing >> corner & 1 == 1) {
            let block = self.beside(first, corner).expect("a box within the field");
            self.found_or_grown(0, block);
        }
        self.find_around(first)
    }

    /// The block of an element of a sparse branch, whose cell becomes active.
    #[inline(always)]
    pub(crate) fn touch(&self, m: usize, block: &Block, inner: &[u32; MAX_AXES]) -> *mut u8 {
        let brick = self.brick(m, block);
        let brick = if core::ptr::eq(brick, self.store(m).background) { self.grow(m, block) } else { brick };
        self.activate_in(m, brick, block, inner);
        brick
    }

    /// A block, where it is not worth the code to look it up in place; where there is none, the background's.
    #[inline(never)]
    pub(crate) fn found(self, m: usize, block: Block) -> *mut u8 {
        self.brick(m, &block)
    }

    /// A block, made where there is none: apart, for whoever has seen that there was none.
    #[cold]
    #[inline(never)]
    pub(crate) fn found_or_grown(self, m: usize, block: Block) -> *mut u8 {
        let brick = self.brick(m, &block);
        if core::ptr::eq(brick, self.store(m).background) { self.grow(m, &block) } else { brick }
    }

    /// Makes a cell of a block that is there active.
    #[inline(always)]
    pub(crate) fn activate_in(&self, m: usize, brick: *mut u8, block: &Block, inner: &[u32; MAX_AXES]) {
        if const { L::BRANCHES > 1 || Map::<R, L, X>::grain(0) > 0 }
            && let Some(bit) = Map::<R, L, X>::cell_number(m, inner).checked_div(Map::<R, L, X>::grain(m))
        {
            let (word, bit) = Store::bit_of(brick, Map::<R, L, X>::bits_at(m), bit);
            // Read first: neighbours of many threads share the word.
            if word.load(Ordering::Relaxed) & bit == 0 {
                word.fetch_or(bit, Ordering::Relaxed);
                self.store(m).mark();
            }
        }
        // A condition on the type first: what it leaves out is then not compiled at all.
        if const { Map::<R, L, X>::list().is_some() }
            && let Some(list) = const { Map::<R, L, X>::list() }
        {
            let entry = (block[list.axis] as usize) * list.chunk + inner[list.axis] as usize;
            Self::extend(*self, *block, entry + 1);
        }
    }

    /// Makes a list have so many entries at least.
    #[inline(never)]
    fn extend(self, block: Block, len: usize) {
        let Some(list) = (const { Map::<R, L, X>::list() }) else { return };
        assert!(len <= list.most, "an entry within the list's maximum");
        let store = self.store(0);
        let head = Map::<R, L, X>::head::<true>(&self.geometry, store, &block).expect("a list that was just made");
        if head.extend(len) {
            // The entries before it are there now, too.
            for chunk in 0..len.div_ceil(list.chunk) {
                let mut at = block;
                at[list.axis] = chunk as u32;
                Map::<R, L, X>::grow(&self.geometry, store, 0, &at);
            }
            store.mark();
        }
    }

    /// Makes a block, and remembers it.
    #[inline(always)]
    pub(crate) fn grow(&self, m: usize, block: &Block) -> *mut u8 {
        // Copies, as in `brick`.
        Self::grow_cold(*self, m, *block)
    }

    #[cold]
    #[inline(never)]
    fn grow_cold(self, m: usize, block: Block) -> *mut u8 {
        let brick = Map::<R, L, X>::grow(&self.geometry, self.store(m), m, &block);
        if !self.paths.is_null() {
            // SAFETY: as in `brick`.
            unsafe { (*self.paths).put(&block, self.copy + Map::<R, L, X>::branch(m) as u32, brick) };
        }
        brick
    }

    /// A member's first component at a place in a block of a sparse branch, and the distance of its components.
    #[inline(always)]
    pub(crate) fn component_in(&self, m: usize, brick: *mut u8, inner: &[u32; MAX_AXES]) -> (*mut u8, usize) {
        let offset = Map::<R, L, X>::start(&self.geometry, m).wrapping_add(sum::<X>(
            #[inline(always)]
            |a| Map::<R, L, X>::inner(m, a, inner[a] as usize),
        ));
        (brick.wrapping_add(offset), Map::<R, L, X>::component(&self.geometry, m))
    }

    /// A member's first component at an element, and the distance of its components: to be read.
    #[inline(always)]
    pub(crate) fn component(&self, m: usize, at: [u32; MAX_AXES]) -> (*mut u8, usize) {
        if const { L::BRANCHES > 1 || L::CHAIN.is_sparse() } && Map::<R, L, X>::is_sparse(m) {
            let (block, inner) = Self::split(m, at);
            return self.component_in(m, self.brick(m, &block), &inner);
        }
        let offset = Map::<R, L, X>::offset(&self.geometry, m, at);
        (self.root.wrapping_add(offset), Map::<R, L, X>::component(&self.geometry, m))
    }

    /// The same to be written: the element becomes active.
    #[inline(always)]
    pub(crate) fn component_mut(&self, m: usize, at: [u32; MAX_AXES]) -> (*mut u8, usize) {
        if const { L::BRANCHES > 1 || L::CHAIN.is_sparse() } && Map::<R, L, X>::is_sparse(m) {
            let (block, inner) = Self::split(m, at);
            return self.component_in(m, self.touch(m, &block, &inner), &inner);
        }
        self.component(m, at)
    }

    /// The memory that a member of an element lies in: all of the field's, or its block.
    pub(crate) fn region(&self, m: usize, at: [u32; MAX_AXES]) -> Region {
        if Map::<R, L, X>::is_sparse(m) {
            let start = self.brick(m, &Self::split(m, at).0).addr();
            return Region { start, bytes: self.store(m).sizes.brick };
        }
        Region { start: self.root.addr(), bytes: Map::<R, L, X>::bytes(&self.geometry).unwrap_or(0) }
    }

    /// Reads a path at an element.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody writes it meanwhile.
    #[inline(always)]
    pub(crate) unsafe fn read<P: Path<R>>(&self, at: [u32; MAX_AXES]) -> P::Value {
        if const { L::BRANCHES == 1 && L::CHAIN.is_sparse() } {
            // One block holds all members.
            let (block, inner) = Self::split(P::OFFSET, at);
            let brick = self.brick(P::OFFSET, &block);
            // SAFETY: as below.
            return unsafe {
                P::gather(
                    #[inline(always)]
                    |m| self.component_in(m, brick, &inner),
                )
            };
        }
        // SAFETY: components of elements within the shape lie in the field's memory, which holds values of their types.
        unsafe {
            P::gather(
                #[inline(always)]
                |m| self.component(m, at),
            )
        }
    }

    /// Writes a path at an element, which becomes active.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody reads or writes it meanwhile.
    #[inline(always)]
    pub(crate) unsafe fn write<P: Path<R>>(&self, at: [u32; MAX_AXES], value: P::Value) {
        if const { L::BRANCHES == 1 && L::CHAIN.is_sparse() } {
            let (block, inner) = Self::split(P::OFFSET, at);
            let brick = self.touch(P::OFFSET, &block, &inner);
            // SAFETY: as below.
            return unsafe {
                P::scatter(
                    value,
                    #[inline(always)]
                    |m| self.component_in(m, brick, &inner),
                )
            };
        }
        // SAFETY: as for `read`, and the caller has the element to itself.
        unsafe {
            P::scatter(
                value,
                #[inline(always)]
                |m| self.component_mut(m, at),
            )
        }
    }

    /// Whether an index lies within the shape.
    #[inline(always)]
    pub(crate) fn locate(&self, index: impl IntoIndex<X>) -> Option<[u32; MAX_AXES]> {
        within::<X>(index.coordinates(), &self.geometry)
    }

    /// Whether the element at a place is active in a member's branch.
    pub(crate) fn is_active_at(&self, m: usize, at: [u32; MAX_AXES]) -> bool {
        if !Map::<R, L, X>::is_sparse(m) {
            return true;
        }
        let (block, inner) = Self::split(m, at);
        if let Some(list) = const { Map::<R, L, X>::list() } {
            return (at[list.axis] as usize) < self.list_len(&block);
        }
        let brick = Map::<R, L, X>::find(&self.geometry, self.store(m), m, &block);
        let grain = Map::<R, L, X>::grain(m);
        if brick.is_null() || grain == 0 {
            return !brick.is_null();
        }
        let bit = Map::<R, L, X>::cell_number(m, &inner) / grain;
        let (word, bit) = Store::bit_of(brick, Map::<R, L, X>::bits_at(m), bit);
        word.load(Ordering::Relaxed) & bit != 0
    }

    /// The entries of the list at a block's place.
    pub(crate) fn list_len(&self, block: &Block) -> usize {
        let Some(list) = (const { Map::<R, L, X>::list() }) else { return 0 };
        Map::<R, L, X>::head::<false>(&self.geometry, self.store(0), block).map_or(0, |head| head.len(list.most))
    }

    /// The active elements of a member's sparse branch, as they are now: the list is made anew where activity has changed.
    pub(crate) fn actives(&self, m: usize) -> Arc<ActiveList> {
        let store = self.store(m);
        let mut actives = store.actives.lock();
        // Asked first: what changes from here on is marked again.
        let stale = store.take_mark();
        if let Some(list) = &actives.newest
            && !stale
            && actives.making == 0
        {
            return Arc::clone(list);
        }
        actives.making += 1;
        drop(actives);
        // Without the lock: a thread that waits for its helpers may be given work that asks for the list, too.
        let list = Arc::new(Map::<R, L, X>::active(&self.geometry, store, m));
        let mut actives = store.actives.lock();
        actives.making -= 1;
        if let Some(old) = actives.newest.replace(Arc::clone(&list)) {
            // A loop may still be running over it.
            actives.older.push(old);
        }
        list
    }
}
