//! `pointer`: a block whose cells are allocated when they are first written.

use super::levels::{Block, Brick, Levels, ListSpec, cell_offset, nth_block, slot};
use super::node::Inner;
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;
use crate::store::Store;
use crate::store::slot::Slot;

/// `pointer(ij, 16)` with the dense nodes above it, `C`: each cell points to what stands below, `Rest`.
#[derive(Clone, Copy, Debug)]
pub struct Table<C, Rest>(core::marker::PhantomData<fn() -> (C, Rest)>);
impl<C, Rest> Sealed for Table<C, Rest> {}

const SLOT: usize = size_of::<Slot>();

/// The sizes of the nodes of a level and of those below.
pub(super) const fn sizes(own: usize, below: &[usize]) -> [usize; super::node::MOST_NODES] {
    let mut sizes = [0; super::node::MOST_NODES];
    sizes[0] = own;
    let mut n = 0;
    while n < below.len() && below[n] > 0 {
        sizes[n + 1] = below[n];
        n += 1;
    }
    sizes
}

// SAFETY: a block's path is a function of its place, one to one: each level takes a digit of each axis.
unsafe impl<C: Inner<X>, Rest: Levels<X>, X: Axes> Levels<X> for Table<C, Rest> {
    const SPAN: PerAxis = {
        let (mut span, mut a) = ([1; MAX_AXES], 0);
        while a < MAX_AXES {
            span[a] = C::EXTENT[a] * Rest::SPAN[a];
            a += 1;
        }
        span
    };
    const BYTES: usize = C::CELLS * SLOT;
    const SIZES: &'static [usize] = &sizes(C::CELLS * SLOT, Rest::SIZES);
    const LIST: Option<ListSpec> = Rest::LIST;

    #[inline(always)]
    unsafe fn find(node: *mut u8, block: &Block) -> *mut u8 {
        let offset = cell_offset::<C, X>(block, const { &Rest::SPAN }, SLOT);
        // SAFETY: the cell is one of the node's.
        let below = unsafe { slot(node.add(offset)) }.get();
        if Rest::BYTES == 0 || below.is_null() {
            return below;
        }
        // SAFETY: a slot of this level holds a node of the next.
        unsafe { Rest::find(below, block) }
    }

    unsafe fn grow(node: *mut u8, block: &Block, store: &Store, depth: usize) -> *mut u8 {
        let offset = cell_offset::<C, X>(block, const { &Rest::SPAN }, SLOT);
        // SAFETY: the cell is one of the node's.
        let below = unsafe { slot(node.add(offset)) }.get_or_make(|| store.new_node(Rest::BYTES, depth + 1));
        // SAFETY: a slot of this level holds a node of the next.
        unsafe { Rest::grow(below, block, store, depth + 1) }
    }

    unsafe fn head<const GROW: bool>(
        node: *mut u8,
        block: &Block,
        store: &Store,
        depth: usize,
    ) -> *mut crate::store::list::Head {
        let offset = cell_offset::<C, X>(block, const { &Rest::SPAN }, SLOT);
        // SAFETY: the cell is one of the node's.
        let slot = unsafe { slot(node.add(offset)) };
        let below = if GROW { slot.get_or_make(|| store.new_node(Rest::BYTES, depth + 1)) } else { slot.get() };
        if below.is_null() {
            return core::ptr::null_mut();
        }
        // SAFETY: a slot of this level holds a node of the next.
        unsafe { Rest::head::<GROW>(below, block, store, depth + 1) }
    }

    unsafe fn walk(node: *mut u8, first: Block, visit: &mut dyn FnMut(Brick)) {
        for n in 0..C::CELLS {
            // SAFETY: the cell is one of the node's.
            let below = unsafe { slot(node.add(n * SLOT)) }.get();
            if !below.is_null() {
                // SAFETY: a slot of this level holds a node of the next.
                unsafe { Rest::walk(below, nth_block::<C, X>(&first, &Rest::SPAN, n), visit) };
            }
        }
    }

    unsafe fn release(node: *mut u8, block: &Block, store: &Store, depth: usize) {
        let offset = cell_offset::<C, X>(block, const { &Rest::SPAN }, SLOT);
        // SAFETY: the cell is one of the node's.
        let slot = unsafe { slot(node.add(offset)) };
        let below = slot.get();
        if below.is_null() {
            return;
        }
        if Rest::BYTES == 0 {
            store.give_node(slot.take(), 0, depth + 1);
            return;
        }
        // SAFETY: a slot of this level holds a node of the next.
        unsafe { Rest::release(below, block, store, depth + 1) };
    }

    unsafe fn sweep(
        node: *mut u8,
        first: Block,
        store: &Store,
        depth: usize,
        keep: &mut dyn FnMut(Brick) -> bool,
    ) -> bool {
        let mut empty = true;
        for n in 0..C::CELLS {
            // SAFETY: the cell is one of the node's.
            let slot = unsafe { slot(node.add(n * SLOT)) };
            let below = slot.get();
            if below.is_null() {
                continue;
            }
            // SAFETY: a slot of this level holds a node of the next; the caller has the field to itself.
            if unsafe { Rest::sweep(below, nth_block::<C, X>(&first, &Rest::SPAN, n), store, depth + 1, keep) } {
                store.give_node(slot.take(), Rest::BYTES, depth + 1);
            } else {
                empty = false;
            }
        }
        empty
    }
}
