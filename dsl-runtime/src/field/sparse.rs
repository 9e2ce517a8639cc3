//! What the host asks of sparse fields, and does to their activity.

use core::sync::atomic::Ordering;
use std::sync::PoisonError;

use super::elements::{Elements, active_places};
use super::host::{Places, out_of_range};
use super::{Field, Handle, Storage};
use crate::axes::{Axes, MAX_AXES};
use crate::index::IntoIndex;
use crate::layout::node::nth_cell;
use crate::layout::{Block, Chain, Geometry, Layout, Map};
use crate::record::{ElementList, Path, Record, Whole};
use crate::store::Store;

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// A field without bounds, in a layout whose outermost node is `hash`: any index of `i32`s but the very last is its own, and memory
    /// is held for what is active alone. [`shape`](Self::shape) and [`origin`](Self::origin) say so.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut plane = Field::<u8, layout!(hash(ij).bitmasked(ij, 8).aos), Ij>::unbounded();
    /// plane.set([-2_000_000, 1_000_000_000], 1);
    /// assert_eq!((plane.active_len(), plane.get([0, 0])), (1, 0));
    /// ```
    ///
    /// # Panics
    /// Where the layout has another root: such a field has extents, and is made by [`new`](Field::new).
    pub fn unbounded() -> Self {
        Map::<R, L, X>::complete();
        assert!(
            Map::<R, L, X>::is_unbounded(),
            "`{}`: only a layout whose outermost node is `hash` is unbounded: give `new` the extents",
            core::any::type_name::<R>()
        );
        let geometry = Geometry::unbounded::<L, X>();
        Self::with_storage(Storage::new_or_abort::<R, L, X>(&geometry), geometry)
    }

    /// Whether the element at an index is active: in a dense layout, all are. Where members stand in several branches, whether it is so
    /// in any sparse one.
    ///
    /// Activity is that of the layout's innermost sparse node: all cells of a `dense` block under a `pointer` are active or none.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, Sparse<8>>::new([64, 64]);
    /// assert!(!smoke.is_active([3, 5]));
    /// smoke.set([3, 5], 0.5);
    /// assert!(smoke.is_active([3, 5]) && smoke.is_active([0, 7]) && !smoke.is_active([8, 0]));
    /// ```
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn is_active(&self, index: impl IntoIndex<X>) -> bool {
        let at = self.find(index).unwrap_or_else(|error| out_of_range::<R>(&error));
        branches::<R, L, X>().into_iter().any(|m| self.handle().is_active_at(m, at))
    }

    /// Makes the element at an index active, and the path to it. It holds the background if it was not. In dense layouts, nothing happens.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn activate(&mut self, index: impl IntoIndex<X>) {
        let at = self.find(index).unwrap_or_else(|error| out_of_range::<R>(&error));
        for m in branches::<R, L, X>() {
            self.handle_mut().activate_at(m, at);
        }
    }

    /// Makes the element at an index inactive, and with it all that are active or not together with it. Its block goes back to the field,
    /// which reuses it. Of a list, it is the entry that is removed. In dense layouts, nothing happens.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, layout!(pointer(ij).bitmasked(ij, 8).aos)>::new([64, 64]).with_background(0.25);
    /// smoke.set([3, 5], 0.5);
    /// smoke.deactivate([3, 5]);
    /// assert!(!smoke.is_active([3, 5]));
    /// assert_eq!(smoke.get([3, 5]), 0.25);
    /// ```
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    pub fn deactivate(&mut self, index: impl IntoIndex<X>) {
        let at = self.find(index).unwrap_or_else(|error| out_of_range::<R>(&error));
        let handle = self.handle_mut();
        for m in branches::<R, L, X>() {
            handle.defer(m, at);
        }
        handle.settle();
    }

    /// How many elements are active: all, where the layout is dense.
    ///
    /// Where members stand in several branches, those that are active in any, or all where one of them is dense.
    pub fn active_len(&self) -> usize {
        match branches::<R, L, X>()[..] {
            [m] if Map::<R, L, X>::branch(0) == 0 && L::BRANCHES == 1 => active_places(&self.handle(), m).len(),
            _ => Elements::of::<Whole, R, L, X>(&self.handle()).len(),
        }
    }

    /// The active elements with their indices, in logical row-major order.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, layout!(pointer(ij).bitmasked(ij, 8).aos)>::new([64, 64]);
    /// smoke.set([30, 5], 0.5);
    /// smoke.set([3, 50], 1.5);
    /// let active: Vec<_> = smoke.active_iter().collect();
    /// assert_eq!(active, [(ivec2(3, 50), 1.5), (ivec2(30, 5), 0.5)]);
    /// ```
    pub fn active_iter(&self) -> impl Iterator<Item = (X::Index, R)> + '_ {
        let handle = self.handle();
        let elements = Elements::of::<Whole, R, L, X>(&handle);
        let (mut next, len) = (0, elements.len());
        core::iter::from_fn(move || {
            if next == len {
                return None;
            }
            next += 1;
            let at = match &elements {
                Elements::All(_) => elements.part::<X>(next - 1..next).next()?,
                Elements::Active(places) => places[next - 1],
            };
            // SAFETY: elements lie within the shape; `&self` keeps writers away.
            Some((X::index(handle.geometry.logical(at)), unsafe { handle.read::<Whole>(at) }))
        })
    }

    /// The first indices of the blocks that are held, in memory order. A block is what is allocated at once: the nodes below the innermost
    /// `pointer`, `hash` or `dynamic`. A dense layout has none.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, Sparse<8>>::new([64, 64]);
    /// smoke.set([30, 5], 0.5);
    /// assert_eq!(smoke.blocks().collect::<Vec<_>>(), [ivec2(24, 0)]);
    /// ```
    pub fn blocks(&self) -> impl ExactSizeIterator<Item = X::Index> + '_ {
        let handle = self.handle();
        let mut first = Vec::new();
        for m in branches::<R, L, X>() {
            let extent = Map::<R, L, X>::chain(m).extent;
            Map::<R, L, X>::walk(&handle.geometry, handle.store(m), m, &mut |brick| {
                first.push(X::index(
                    handle.geometry.logical(core::array::from_fn(|a| brick.block[a] * extent[a] as u32)),
                ));
            });
        }
        first.into_iter()
    }

    /// Makes all elements inactive; the blocks go back to the field, which reuses them. In dense branches, every element gets the
    /// background, which is zero there.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, Sparse<8>>::new([64, 64]);
    /// smoke.set([30, 5], 0.5);
    /// smoke.clear();
    /// assert_eq!((smoke.active_len(), smoke.get([30, 5])), (0, 0.0));
    /// ```
    pub fn clear(&mut self) {
        let handle = self.handle_mut();
        for (m, spec) in R::Elements::MEMBERS.iter().enumerate().filter(|&(m, _)| !Map::<R, L, X>::is_sparse(m)) {
            for at in Places::<X>::new(handle.geometry.shape) {
                let (first, step) = handle.component(m, at);
                for c in 0..spec.components {
                    // SAFETY: a component of an element within the shape; `&mut self` is exclusive.
                    unsafe { first.wrapping_add(c * step).write_bytes(0, spec.scalar) };
                }
            }
        }
        let geometry = self.geometry;
        Map::<R, L, X>::clear(&geometry, &mut self.storage.stores_mut());
        self.forget();
    }

    /// Gives back every block that holds the background alone: its cells become inactive. Memory of which no block is in use goes back to
    /// the system.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut smoke = Field::<f32, Sparse<8>>::new([64, 64]);
    /// smoke.set([30, 5], 0.5);
    /// smoke.set([3, 5], 0.0);
    /// assert_eq!(smoke.blocks().len(), 2);
    /// smoke.prune();
    /// assert_eq!(smoke.blocks().len(), 1);
    /// assert!(!smoke.is_active([3, 5]));
    /// ```
    pub fn prune(&mut self) {
        self.storage.settle();
        let geometry = self.geometry;
        Map::<R, L, X>::prune(&geometry, &mut self.storage.stores_mut());
        self.forget();
        self.storage.stores_mut().for_each(Store::shrink);
        self.spare.get_mut().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// Lists of active blocks are made anew.
    fn forget(&mut self) {
        for store in self.storage.stores_mut() {
            store.mark();
            let actives = store.actives.get_mut();
            *actives = Default::default();
        }
    }

    /// Sets what inactive elements hold, and all cells of the blocks that are there.
    pub(super) fn set_background(&mut self, record: R) {
        for m in branches::<R, L, X>() {
            let geometry = self.geometry;
            let handle = Handle::<R, L, X>::new(core::ptr::null_mut(), geometry, None, false);
            let write = |brick: *mut u8| {
                for inner in cells::<X>(Map::<R, L, X>::chain(m)) {
                    // SAFETY: the brick is a block of this branch, which `&mut self` keeps others from.
                    unsafe { handle.write_in(m, brick, &inner, record) };
                }
            };
            let store = self.storage.store_mut(Map::<R, L, X>::sparse_branch(m));
            store.set_background(write);
            Map::<R, L, X>::walk(&geometry, store, m, &mut |brick| write(brick.start));
        }
    }

    /// What an inactive element holds: zero, or what [`with_background`](Self::with_background) has said. In dense layouts, where all are
    /// active, zero.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let far = Field::<f32, Sparse<8>>::new([64, 64]).with_background(f32::INFINITY);
    /// assert_eq!((far.background(), far.active_len()), (f32::INFINITY, 0));
    /// ```
    pub fn background(&self) -> R {
        let handle = self.handle();
        let zeros = Scratch::default();
        // SAFETY: components of a block, or of scratch memory that holds zeros, which are values of every element.
        unsafe {
            Whole::gather(|m| match Map::<R, L, X>::is_sparse(m) {
                true => handle.component_in(m, handle.store(m).background, &[0; MAX_AXES]),
                false => zeros.component::<R>(m),
            })
        }
    }
}

/// Room for the components of any element.
#[derive(Default)]
struct Scratch([core::cell::Cell<u128>; 16]);

impl Scratch {
    /// Where an element's components go.
    fn component<R: Record>(&self, m: usize) -> (*mut u8, usize) {
        let spec = &R::Elements::MEMBERS[m];
        assert!(spec.components * spec.scalar <= size_of::<Self>(), "an element that fits");
        (self.0.as_ptr().cast_mut().cast(), spec.scalar)
    }
}

/// The places of a block's cells, in memory order.
pub(crate) fn cells<X: Axes>(chain: &Chain) -> impl Iterator<Item = [u32; MAX_AXES]> + '_ {
    (0..chain.cells).map(|n| nth_cell::<X>(chain.digits, chain.extent, chain.cells, n).map(|c| c as u32))
}

impl<R: Record, L: Layout<X>, X: Axes> Handle<'_, R, L, X> {
    /// Writes the members of a sparse branch in a cell of a block.
    ///
    /// # Safety
    /// The block is one of that branch, and nobody else reaches it.
    unsafe fn write_in(&self, m: usize, brick: *mut u8, inner: &[u32; MAX_AXES], record: R) {
        let scratch = Scratch::default();
        let branch = Map::<R, L, X>::branch(m);
        // SAFETY: components of a cell of the block; those of other branches go to the scratch memory.
        unsafe {
            Whole::scatter(record, |member| match Map::<R, L, X>::branch(member) == branch {
                true => self.component_in(member, brick, inner),
                false => scratch.component::<R>(member),
            });
        }
    }

    /// Writes one member of a record at an element, which becomes active in that member's branch.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody reads or writes it meanwhile.
    pub(crate) unsafe fn write_member(&self, m: usize, at: [u32; MAX_AXES], record: R) {
        let scratch = Scratch::default();
        // SAFETY: a component of the element; those of other members go to the scratch memory.
        unsafe {
            Whole::scatter(record, |member| match member == m {
                true => self.component_mut(m, at),
                false => scratch.component::<R>(member),
            });
        }
    }

    /// Makes the element at a place active in a member's branch.
    pub(crate) fn activate_at(&self, m: usize, at: [u32; MAX_AXES]) {
        if Map::<R, L, X>::is_sparse(m) {
            let (block, inner) = Self::split(m, at);
            self.touch(m, &block, &inner);
        }
    }

    /// Notes that the element at a place of a sparse branch is to become inactive.
    pub(crate) fn defer(&self, m: usize, at: [u32; MAX_AXES]) {
        self.store(m).pending.lock().push(at);
    }

    /// Makes inactive what was noted, where the field is held exclusively.
    pub(crate) fn settle(&self) {
        if !self.exclusive {
            return;
        }
        for m in branches::<R, L, X>() {
            let store = self.store(m);
            let mut pending = core::mem::take(&mut *store.pending.lock());
            if pending.is_empty() {
                continue;
            }
            crate::index::sort(&mut pending);
            pending.dedup();
            match Map::<R, L, X>::list() {
                Some(list) => self.remove_entries(list.axis, pending),
                None => self.release(m, &pending),
            }
            store.mark();
        }
    }

    /// Makes elements of a branch without lists inactive.
    fn release(&self, m: usize, places: &[[u32; MAX_AXES]]) {
        let (store, chain, grain) = (self.store(m), Map::<R, L, X>::chain(m), Map::<R, L, X>::grain(m));
        let mut blocks: Vec<Block> = Vec::new();
        for &at in places {
            let (block, inner) = Self::split(m, at);
            let brick = Map::<R, L, X>::find(&self.geometry, store, m, &block);
            if brick.is_null() {
                continue;
            }
            blocks.push(block);
            if grain == 0 {
                continue;
            }
            let number = Map::<R, L, X>::cell_number(m, &inner) / grain;
            let (word, bit) = Store::bit_of(brick, store.sizes.bits_at, number);
            if word.fetch_and(!bit, Ordering::Relaxed) & bit != 0 {
                for cell in number * grain..(number + 1) * grain {
                    let inner = nth_cell::<X>(chain.digits, chain.extent, chain.cells, cell).map(|c| c as u32);
                    self.reset(m, brick, &inner);
                }
            }
        }
        crate::index::sort(&mut blocks);
        blocks.dedup();
        // Blocks without an active cell go back.
        blocks.retain(|block| {
            let brick = Map::<R, L, X>::find(&self.geometry, store, m, block);
            let words = store.sizes.bits.div_ceil(64);
            let word = |n: usize| Store::bit_of(brick, store.sizes.bits_at, 64 * n).0.load(Ordering::Relaxed);
            (0..words).all(|n| word(n) == 0)
        });
        Map::<R, L, X>::release(&self.geometry, store, m, &blocks);
    }

    /// Puts the background into a cell of a block.
    fn reset(&self, m: usize, brick: *mut u8, inner: &[u32; MAX_AXES]) {
        let background = self.store(m).background;
        for (member, spec) in R::Elements::MEMBERS.iter().enumerate() {
            if Map::<R, L, X>::branch(member) != Map::<R, L, X>::branch(m) {
                continue;
            }
            let (to, step) = self.component_in(member, brick, inner);
            let (from, _) = self.component_in(member, background, inner);
            for c in 0..spec.components {
                // SAFETY: components of one cell of two blocks; the field is held exclusively.
                unsafe { to.add(c * step).copy_from_nonoverlapping(from.add(c * step), spec.scalar) };
            }
        }
    }

    /// Takes entries out of their lists; the others move up, in their order.
    fn remove_entries(&self, axis: usize, mut places: Vec<[u32; MAX_AXES]>) {
        if const { Map::<R, L, X>::list().is_none() } {
            return;
        }
        sort_by_list(axis, &mut places);
        for entries in places.chunk_by(|a, b| list_of(axis, a) == list_of(axis, b)) {
            let removed = |n: usize| entries.binary_search_by_key(&n, |at| at[axis] as usize).is_ok();
            self.retain_entries(&entries[0], axis, |n, _| !removed(n));
        }
    }

    /// Keeps those entries of the list that a place is in which `keep` keeps, in their order.
    pub(crate) fn retain_entries(&self, list: &[u32; MAX_AXES], axis: usize, mut keep: impl FnMut(usize, &R) -> bool) {
        let at = |n: usize| core::array::from_fn::<u32, MAX_AXES, _>(|a| if a == axis { n as u32 } else { list[a] });
        let (block, _) = Self::split(0, at(0));
        let len = self.list_len(&block);
        let mut kept = 0;
        for n in 0..len {
            // SAFETY: entries that the list has; the field is held exclusively.
            let record = unsafe { self.read::<Whole>(at(n)) };
            if keep(n, &record) {
                if kept < n {
                    // SAFETY: as above.
                    unsafe { self.write::<Whole>(at(kept), record) };
                }
                kept += 1;
            }
        }
        for n in kept..len {
            let (block, inner) = Self::split(0, at(n));
            self.reset(0, self.brick(0, &block), &inner);
        }
        if kept < len {
            let store = self.store(0);
            if let Some(head) = Map::<R, L, X>::head::<false>(&self.geometry, store, &block) {
                head.set_len(kept);
            }
            store.mark();
        }
    }
}

/// One member of each sparse branch.
pub(crate) fn branches<R: Record, L: Layout<X>, X: Axes>() -> Vec<usize> {
    let mut first = Vec::new();
    for m in 0..R::Elements::MEMBERS.len() {
        let known = |&other: &usize| Map::<R, L, X>::branch(other) == Map::<R, L, X>::branch(m);
        if Map::<R, L, X>::is_sparse(m) && !first.iter().any(known) {
            first.push(m);
        }
    }
    first
}

/// The place of the list that an entry is in.
fn list_of(axis: usize, at: &[u32; MAX_AXES]) -> [u32; MAX_AXES] {
    core::array::from_fn(|a| if a == axis { 0 } else { at[a] })
}

/// Puts entries in the order of their lists, and of one list in the list's. Sorting is much code: there is one copy of it for all layouts.
#[inline(never)]
fn sort_by_list(axis: usize, places: &mut [[u32; MAX_AXES]]) {
    places.sort_unstable_by_key(|at| (list_of(axis, at), at[axis]));
}
