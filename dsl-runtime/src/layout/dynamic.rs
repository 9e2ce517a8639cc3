//! `dynamic`: lists that grow by `append`.

use super::levels::{Block, Brick, Levels, ListSpec, cell_offset, nth_block, slot};
use super::node::{Inner, order};
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;
use crate::store::Store;
use crate::store::list::Head;
use crate::store::slot::Slot;

/// `dynamic(j, 1024, chunk = 32)` with the dense nodes above it, `C`: each cell is a list along the axis of `AXIS`, of at most `MOST`
/// entries in blocks of `CHUNK`, or in one block where that is 0.
#[derive(Clone, Copy, Debug)]
pub struct List<C, const AXIS: u32, const MOST: usize, const CHUNK: usize>(core::marker::PhantomData<fn() -> C>);
impl<C, const AXIS: u32, const MOST: usize, const CHUNK: usize> Sealed for List<C, AXIS, MOST, CHUNK> {}

const HEAD: usize = size_of::<Head>();
const SLOT: usize = size_of::<Slot>();

impl<C, const AXIS: u32, const MOST: usize, const CHUNK: usize> List<C, AXIS, MOST, CHUNK> {
    /// Entries of a block.
    const BLOCK: usize = if CHUNK == 0 { MOST } else { CHUNK };
    /// Blocks of a list.
    const BLOCKS: usize = MOST.div_ceil(Self::BLOCK);

    /// The list's axis.
    const fn axis<X: Axes>() -> usize {
        assert!(MOST > 0 && MOST < 1 << 31, "the maximum of a list is 1 to i32::MAX");
        assert!(CHUNK <= MOST, "a list's blocks are not larger than its maximum");
        let axis = order::<X>(AXIS).0[0];
        assert!(axis + 1 == X::RANK, "a list's axis is the last");
        axis
    }

    /// The list at a place.
    ///
    /// # Safety
    /// As for [`Levels::find`].
    #[inline(always)]
    unsafe fn at<'a, X: Axes>(node: *mut u8, block: &Block) -> &'a Head
    where
        C: Inner<X>,
    {
        let offset = cell_offset::<C, X>(block, &[1; MAX_AXES], HEAD);
        // SAFETY: the cell is one of the node's, which holds heads; they are changed through shared references alone.
        unsafe { &*node.add(offset).cast::<Head>() }
    }

    /// The slot of a block among a list's pointers.
    ///
    /// # Safety
    /// `pointers` is the node that a list of several blocks points to.
    #[inline(always)]
    unsafe fn chunk<'a>(pointers: *mut u8, n: usize) -> &'a Slot {
        assert!(n < Self::BLOCKS);
        // SAFETY: there are as many pointers as blocks.
        unsafe { slot(pointers.add(n * SLOT)) }
    }

    /// The place of block `n` of a list.
    fn block<X: Axes>(mut at: Block, n: usize) -> Block {
        at[Self::axis::<X>()] = n as u32;
        at
    }
}

// SAFETY: a list's place is a function of a block's, and the block's number along the list's axis is the rest of it.
unsafe impl<C: Inner<X>, const AXIS: u32, const MOST: usize, const CHUNK: usize, X: Axes> Levels<X>
    for List<C, AXIS, MOST, CHUNK>
{
    const SPAN: PerAxis = {
        let mut span = C::EXTENT;
        let axis = Self::axis::<X>();
        assert!(span[axis] == 1, "a list's axis is no other node's");
        span[axis] = Self::BLOCKS;
        span
    };
    const BYTES: usize = C::CELLS * HEAD;
    const SIZES: &'static [usize] = {
        if Self::BLOCKS == 1 {
            &super::pointer::sizes(C::CELLS * HEAD, &[])
        } else {
            &super::pointer::sizes(C::CELLS * HEAD, &[Self::BLOCKS * SLOT])
        }
    };
    const LIST: Option<ListSpec> = Some(ListSpec { axis: Self::axis::<X>(), most: MOST, chunk: Self::BLOCK });

    #[inline(always)]
    unsafe fn find(node: *mut u8, block: &Block) -> *mut u8 {
        // SAFETY: as the caller promises.
        let data = unsafe { Self::at::<X>(node, block) }.data.get();
        if Self::BLOCKS == 1 || data.is_null() {
            return data;
        }
        // SAFETY: a list of several blocks points to their pointers.
        unsafe { Self::chunk(data, block[const { Self::axis::<X>() }] as usize) }.get()
    }

    unsafe fn grow(node: *mut u8, block: &Block, store: &Store, depth: usize) -> *mut u8 {
        // SAFETY: as the caller promises.
        let data = &unsafe { Self::at::<X>(node, block) }.data;
        if Self::BLOCKS == 1 {
            return data.get_or_make(|| store.new_node(0, depth + 1));
        }
        let pointers = data.get_or_make(|| store.new_node(Self::BLOCKS * SLOT, depth + 1));
        // SAFETY: a list of several blocks points to their pointers.
        unsafe { Self::chunk(pointers, block[Self::axis::<X>()] as usize) }.get_or_make(|| store.new_node(0, depth + 2))
    }

    unsafe fn head<const GROW: bool>(node: *mut u8, block: &Block, _: &Store, _: usize) -> *mut Head {
        // SAFETY: as the caller promises.
        core::ptr::from_ref(unsafe { Self::at::<X>(node, block) }).cast_mut()
    }

    unsafe fn walk(node: *mut u8, first: Block, visit: &mut dyn FnMut(Brick)) {
        for n in 0..C::CELLS {
            // SAFETY: the cell is one of the node's.
            let head = unsafe { &*node.add(n * HEAD).cast::<Head>() };
            let len = head.len(MOST);
            if len == 0 {
                continue;
            }
            let at = nth_block::<C, X>(&first, &[1; MAX_AXES], n);
            let data = head.data.get();
            for chunk in 0..len.div_ceil(Self::BLOCK) {
                let start = match Self::BLOCKS {
                    1 => data,
                    _ if data.is_null() => data,
                    // SAFETY: a list of several blocks points to their pointers.
                    _ => unsafe { Self::chunk(data, chunk) }.get(),
                };
                // Entries that nobody has written yet have no block: another thread has just made the list longer.
                if !start.is_null() {
                    let entries = (len - chunk * Self::BLOCK).min(Self::BLOCK);
                    visit(Brick { start, block: Self::block::<X>(at, chunk), entries });
                }
            }
        }
    }

    unsafe fn release(_: *mut u8, _: &Block, _: &Store, _: usize) {
        unreachable!("entries are removed from lists, not blocks");
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
            let head = unsafe { &*node.add(n * HEAD).cast::<Head>() };
            let (len, at) = (head.len(MOST), nth_block::<C, X>(&first, &[1; MAX_AXES], n));
            let data = head.data.get();
            if data.is_null() {
                empty &= len == 0;
                continue;
            }
            // A list is kept up to the last block that is.
            let mut kept = 0;
            for chunk in (0..Self::BLOCKS).rev() {
                // SAFETY: a list of several blocks points to their pointers.
                let slot = if Self::BLOCKS == 1 { &head.data } else { unsafe { Self::chunk(data, chunk) } };
                let start = slot.get();
                if start.is_null() {
                    continue;
                }
                let entries = len.saturating_sub(chunk * Self::BLOCK).min(Self::BLOCK);
                if entries > 0 && (kept > 0 || keep(Brick { start, block: Self::block::<X>(at, chunk), entries })) {
                    kept = kept.max(chunk * Self::BLOCK + entries);
                } else {
                    store.give_node(slot.take(), 0, depth + 1 + usize::from(Self::BLOCKS > 1));
                }
            }
            head.set_len(kept);
            if kept == 0 && Self::BLOCKS > 1 {
                store.give_node(head.data.take(), Self::BLOCKS * SLOT, depth + 1);
            }
            empty &= kept == 0;
        }
        empty
    }
}
