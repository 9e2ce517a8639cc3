//! What stands above the blocks of a sparse layout: nodes whose cells point to others.

use crate::axes::{Axes, MAX_AXES, PerAxis, per_axis, sum};
use crate::element::Sealed;
use crate::layout::node::{Inner, nth_cell};
use crate::store::Store;
use crate::store::slot::Slot;

/// The place of a block among the blocks of its field.
pub(crate) type Block = [u32; MAX_AXES];

/// A block of cells that the field holds.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Brick {
    /// Where it begins.
    pub(crate) start: *mut u8,
    /// Where it stands.
    pub(crate) block: Block,
    /// How many entries of a list it holds; `usize::MAX` where it is no list's.
    pub(crate) entries: usize,
}

/// What of a list is known at compile time.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct ListSpec {
    /// Its axis.
    pub(crate) axis: usize,
    /// The most entries.
    pub(crate) most: usize,
    /// Entries of a block.
    pub(crate) chunk: usize,
}

/// The nodes above the blocks, from a cell of the root down.
///
/// # Safety
/// `find`, `grow` and `walk` return blocks that the store has made, or null, and no block for two places.
#[doc(hidden)]
pub unsafe trait Levels<X: Axes>: Copy + Send + Sync + Sealed + 'static {
    /// Blocks that a node of the uppermost level spans along each axis.
    const SPAN: PerAxis;
    /// Bytes of such a node; 0 where it is the block itself.
    const BYTES: usize;
    /// Bytes of the nodes of each level, from the uppermost down.
    const SIZES: &'static [usize];
    /// The lists at the bottom, if there are.
    const LIST: Option<ListSpec>;

    /// The block at a place; null where there is none.
    ///
    /// # Safety
    /// `node` is a node of the uppermost level of this kind, zeroed when it was made.
    unsafe fn find(node: *mut u8, block: &Block) -> *mut u8;

    /// The block at a place, made with the path to it where there is none.
    ///
    /// # Safety
    /// As for [`find`](Self::find), of this store, at this depth.
    unsafe fn grow(node: *mut u8, block: &Block, store: &Store, depth: usize) -> *mut u8;

    /// The head of the list at a place, made with the path to it if so asked; null where there is none.
    ///
    /// # Safety
    /// As for [`grow`](Self::grow).
    unsafe fn head<const GROW: bool>(
        node: *mut u8,
        block: &Block,
        store: &Store,
        depth: usize,
    ) -> *mut crate::store::list::Head;

    /// Visits all blocks in the order of the tree.
    ///
    /// # Safety
    /// As for [`find`](Self::find); the node is the one whose first block is `first`.
    unsafe fn walk(node: *mut u8, first: Block, visit: &mut dyn FnMut(Brick));

    /// Gives back the block at a place, if there is one. Of a root's own block, nothing is given back.
    ///
    /// # Safety
    /// As for [`grow`](Self::grow), and nobody uses the block any more.
    unsafe fn release(node: *mut u8, block: &Block, store: &Store, depth: usize);

    /// Gives back the blocks that `keep` does not keep, and nodes that have none any more; all entries of lists if so asked.
    /// Returns whether the node is empty.
    ///
    /// # Safety
    /// As for [`walk`](Self::walk), and the caller has the field to itself.
    unsafe fn sweep(
        node: *mut u8,
        first: Block,
        store: &Store,
        depth: usize,
        keep: &mut dyn FnMut(Brick) -> bool,
    ) -> bool;
}

/// The end of the levels: what stands below is a block.
#[derive(Clone, Copy, Debug)]
pub struct Leaf;
impl Sealed for Leaf {}
// SAFETY: the node is the block itself.
unsafe impl<X: Axes> Levels<X> for Leaf {
    const SPAN: PerAxis = [1; MAX_AXES];
    const BYTES: usize = 0;
    const SIZES: &'static [usize] = &[];
    const LIST: Option<ListSpec> = None;

    #[inline(always)]
    unsafe fn find(node: *mut u8, _: &Block) -> *mut u8 {
        node
    }

    #[inline(always)]
    unsafe fn grow(node: *mut u8, _: &Block, _: &Store, _: usize) -> *mut u8 {
        node
    }

    unsafe fn head<const GROW: bool>(_: *mut u8, _: &Block, _: &Store, _: usize) -> *mut crate::store::list::Head {
        core::ptr::null_mut()
    }

    #[inline]
    unsafe fn walk(node: *mut u8, block: Block, visit: &mut dyn FnMut(Brick)) {
        visit(Brick { start: node, block, entries: usize::MAX });
    }

    unsafe fn release(_: *mut u8, _: &Block, _: &Store, _: usize) {}

    unsafe fn sweep(node: *mut u8, block: Block, _: &Store, _: usize, keep: &mut dyn FnMut(Brick) -> bool) -> bool {
        !keep(Brick { start: node, block, entries: usize::MAX })
    }
}

/// The number of the cell that spans a block, in the order of a node's cells `C`, times `bytes`.
#[inline(always)]
pub(crate) fn cell_offset<C: Inner<X>, X: Axes>(block: &Block, below: &PerAxis, bytes: usize) -> usize {
    sum::<X>(
        #[inline(always)]
        |a| {
            let (below, extent) = (below[a] as u32, C::EXTENT[a] as u32);
            C::term(a, (block[a] / below % extent) as usize, C::LEAF * bytes, bytes)
        },
    )
}

/// The first block of cell `n` of a node whose first block is `first`.
#[inline]
pub(crate) fn nth_block<C: Inner<X>, X: Axes>(first: &Block, below: &PerAxis, n: usize) -> Block {
    let at = nth_cell::<X>(C::DIGITS, C::EXTENT, C::CELLS, n);
    per_axis(|a| if a < X::RANK { first[a] + (at[a] * below[a]) as u32 } else { 0 })
}

/// A slot at an address.
///
/// # Safety
/// There lies one, in memory that lives as long as it is used.
#[inline(always)]
pub(crate) unsafe fn slot<'a>(at: *mut u8) -> &'a Slot {
    debug_assert!(at.cast::<Slot>().is_aligned());
    // SAFETY: as the caller promises; slots are changed through shared references alone.
    unsafe { &*at.cast::<Slot>() }
}
