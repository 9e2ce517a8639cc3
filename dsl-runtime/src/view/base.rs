//! A base index checked once for all constant offsets of a stencil.

use core::cell::Cell;
use core::marker::PhantomData;

use super::Site;
use crate::axes::{Axes, MAX_AXES, PerAxis, for_axes, padded, per_axis};
use crate::field::Handle;
use crate::index::inside;
use crate::layout::{Block, Geometry, Layout};
use crate::record::Record;
use crate::scatter::Window;

/// A base whose whole box of offsets lies within a field's indices.
///
/// With `FILLED`, the loop writes all of the box whatever happens, so that blocks which are not there are made with the base.
#[doc(hidden)]
#[derive(Debug)]
pub struct Based<'b, L: Layout<X>, X: Axes, const FILLED: bool = false> {
    /// The base's place; in wrapping arithmetic, since its own cell may lie below zero.
    base: [u32; MAX_AXES],
    low: [i64; MAX_AXES],
    high: [i64; MAX_AXES],
    /// The field that was checked. The macro uses a base for the field that it was made from alone.
    shape: [u32; MAX_AXES],
    origin: [i32; MAX_AXES],
    /// The blocks around, of a sparse field.
    corners: &'b L::Corners,
    /// Whether they are known, in which set, and whose they are.
    known: bool,
    set: usize,
    root: *mut u8,
    /// The offset along each axis at which the next block begins, and the base's place in the first block.
    edge: [i64; MAX_AXES],
    inner: [i64; MAX_AXES],
    /// The blocks as they were when the base was made: values, not memory that stores to the field might change.
    blocks: [*mut u8; 8],
    axes: PhantomData<X>,
}

/// The blocks around a base: the first of them and the next along each of up to three axes, block `c` the one beside the first along those axes `a`
/// whose bit `1 << a` of `c` is set.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Around {
    pub(crate) blocks: [*mut u8; 8],
    /// Which of them are there, a bit each: the others are the background's.
    pub(crate) there: u8,
}

/// Which blocks around a base a box reaches that leads into the next block along the axes of a mask, a bit each.
const REACHED: [u8; 8] = {
    let mut reached = [0; 8];
    let mut mask = 0;
    while mask < 8 {
        let mut corner = 0;
        while corner < 8 {
            if corner & !mask == 0 {
                reached[mask] |= 1 << corner;
            }
            corner += 1;
        }
        mask += 1;
    }
    reached
};

/// The blocks around the last bases of a job.
///
/// What was not there may have been made since, by whomever: whoever is to write looks again, and whoever reads finds the background in both, as a loop
/// reads no path that it writes but by its own index.
#[doc(hidden)]
pub trait Corners: Default + core::fmt::Debug + 'static {
    /// Whether any are kept.
    const KEPT: bool;
    /// The set of the blocks around `first`.
    fn seek(&self, first: &Block, find: impl FnOnce() -> Around) -> usize;
    /// A block of a set, as [`Around`] numbers them.
    fn get(&self, set: usize, corner: usize) -> *mut u8;
    /// Which of them are there.
    fn there(&self, set: usize) -> u8;
    /// Puts others in their place.
    fn renew(&self, set: usize, around: Around);
    /// Puts another there, which has just been made.
    fn put(&self, set: usize, corner: usize, block: *mut u8);
}
impl Corners for () {
    const KEPT: bool = false;
    #[inline(always)]
    fn seek(&self, _: &Block, _: impl FnOnce() -> Around) -> usize {
        0
    }
    #[inline(always)]
    fn get(&self, _: usize, _: usize) -> *mut u8 {
        core::ptr::null_mut()
    }
    fn there(&self, _: usize) -> u8 {
        0
    }
    fn renew(&self, _: usize, _: Around) {}
    fn put(&self, _: usize, _: usize, _: *mut u8) {}
}

/// How many sets are kept: four along each of the first two axes, and two along the third, so that those of neighbours do not drive each other out.
const SETS: usize = 32;

/// The blocks around bases of a sparse field of up to three axes.
#[doc(hidden)]
#[derive(Debug)]
pub struct EightCorners {
    first: [Cell<Block>; SETS],
    blocks: [[Cell<*mut u8>; 8]; SETS],
    there: [Cell<u8>; SETS],
}
impl Default for EightCorners {
    #[inline(always)]
    fn default() -> Self {
        Self {
            // No block has a place along a fourth axis.
            first: [const { Cell::new([u32::MAX; MAX_AXES]) }; SETS],
            blocks: [const { [const { Cell::new(core::ptr::null_mut()) }; 8] }; SETS],
            there: [const { Cell::new(0) }; SETS],
        }
    }
}
impl Corners for EightCorners {
    const KEPT: bool = true;
    #[inline(always)]
    fn seek(&self, first: &Block, find: impl FnOnce() -> Around) -> usize {
        let set = (first[0] & 3 | (first[1] & 3) << 2 | (first[2] & 1) << 4) as usize;
        if self.first[set].get() != *first {
            self.renew(set, find());
            self.first[set].set(*first);
        }
        set
    }
    #[inline(always)]
    fn get(&self, set: usize, corner: usize) -> *mut u8 {
        self.blocks[set % SETS][corner % 8].get()
    }
    #[inline(always)]
    fn there(&self, set: usize) -> u8 {
        self.there[set % SETS].get()
    }
    #[inline(always)]
    fn renew(&self, set: usize, around: Around) {
        self.there[set % SETS].set(around.there);
        for (block, found) in self.blocks[set % SETS].iter().zip(around.blocks) {
            block.set(found);
        }
    }
    #[inline(always)]
    fn put(&self, set: usize, corner: usize, block: *mut u8) {
        self.blocks[set % SETS][corner % 8].set(block);
        let there = &self.there[set % SETS];
        there.set(there.get() | 1 << (corner % 8));
    }
}

impl<'b, L: Layout<X>, X: Axes, const FILLED: bool> Based<'b, L, X, FILLED> {
    /// Whether the blocks around bases are looked up with them: they are those of one branch.
    pub(super) const CORNERED: bool =
        L::CHAIN.is_sparse() && L::BRANCHES == 1 && X::RANK <= 3 && <L::Corners as Corners>::KEPT;
    /// Whether all blocks that the box reaches are there, where those around are known. Lists grow entry by entry.
    pub(super) const THERE: bool =
        FILLED && Self::CORNERED && matches!(L::CHAIN.tree, Some(tree) if tree.list.is_none());

    #[inline(always)]
    pub(super) fn new<const N: usize>(
        geometry: &Geometry,
        window: &Window,
        corners: &'b L::Corners,
        base: [i64; MAX_AXES],
        low: [i64; N],
        high: [i64; N],
    ) -> Option<Self> {
        assert!(N == X::RANK);
        Self::around(geometry, window, corners, base, padded(low), padded(high))
    }

    /// The same with offsets for all axes that there could be.
    #[inline(always)]
    pub(super) fn around(
        geometry: &Geometry,
        window: &Window,
        corners: &'b L::Corners,
        base: [i64; MAX_AXES],
        low: [i64; MAX_AXES],
        high: [i64; MAX_AXES],
    ) -> Option<Self> {
        let (shape, origin) = (geometry.shape, geometry.origin);
        let mut fits = true;
        for_axes!(X, A => {
            // `base` came from integers of at most 64 bits: extremes must not wrap around.
            let (first, last) = (base[A].saturating_add(low[A]), base[A].saturating_add(high[A]));
            let (start, end) = window.span(geometry, A);
            fits &= (first >= start) & (last < end);
        });
        fits.then(
            #[inline(always)]
            || Self {
                base: geometry.place(base),
                low,
                high,
                shape,
                origin,
                corners,
                known: false,
                set: 0,
                root: core::ptr::null_mut(),
                edge: [i64::MAX; MAX_AXES],
                inner: [0; MAX_AXES],
                blocks: [core::ptr::null_mut(); 8],
                axes: PhantomData,
            },
        )
    }

    /// Finds the blocks around the base.
    #[inline(always)]
    pub(super) fn cornered<R: Record>(mut self, handle: &Handle<'_, R, L, X>) -> Self {
        if const { !Self::CORNERED } {
            return self;
        }
        let extent = const { &L::CHAIN.extent };
        // A wider box reaches more than one further block.
        let mut near = true;
        for_axes!(X, A => near &= self.high[A].wrapping_sub(self.low[A]) as u64 <= extent[A] as u64);
        if !near {
            return self;
        }
        let mut first = [0; MAX_AXES];
        for_axes!(X, A => {
            let start = self.base[A].wrapping_add(self.low[A] as u32);
            first[A] = start / extent[A] as u32;
            let inner = start % extent[A] as u32;
            self.edge[A] = self.low[A] + i64::from(extent[A] as u32 - inner);
            self.inner[A] = i64::from(inner) - self.low[A];
        });
        (self.known, self.root) = (true, handle.root);
        self.set = handle.around(self.corners, first);
        if const { Self::THERE } {
            let mut over = 0;
            for_axes!(X, A => over |= usize::from(self.high[A] >= self.edge[A]) << A);
            let missing = REACHED[over % 8] & !self.corners.there(self.set);
            if missing != 0 {
                handle.grow_around(self.corners, self.set, first, missing);
            }
        }
        let blocks = |corner: usize| self.corners.get(self.set, corner);
        self.blocks[0] = blocks(0);
        self.blocks[1] = blocks(1);
        if const { X::RANK > 1 } {
            self.blocks[2] = blocks(2);
            self.blocks[3] = blocks(3);
        }
        if const { X::RANK > 2 } {
            self.blocks[4] = blocks(4);
            self.blocks[5] = blocks(5);
            self.blocks[6] = blocks(6);
            self.blocks[7] = blocks(7);
        }
        self
    }

    /// Whether an offset lies in the box.
    #[inline(always)]
    pub(super) fn holds(&self, offset: [i64; MAX_AXES]) -> bool {
        let mut holds = true;
        for_axes!(X, A => holds &= (offset[A] >= self.low[A]) & (offset[A] <= self.high[A]));
        holds
    }

    /// Which of the blocks around an offset in the box lies in.
    #[inline(always)]
    fn corner_of(&self, offset: [i64; MAX_AXES]) -> usize {
        let mut corner = 0;
        for_axes!(X, A => corner |= usize::from(offset[A] >= self.edge[A]) << A);
        corner
    }

    /// Whether the blocks around are known.
    #[inline(always)]
    pub(super) fn is_known(&self) -> bool {
        self.known
    }

    /// Whether the blocks around, where they are known, are those of a root: the field's, or that of a job's copy of it.
    #[inline(always)]
    pub(super) fn is_of(&self, root: *mut u8) -> bool {
        !self.known || core::ptr::eq(root, self.root)
    }

    /// The address of an offset in the box, in blocks whose elements lie at even distances along each axis: `STEP` bytes apart, so that block `c`
    /// ends `back[c]` bytes before it would if the first went on. The blocks around are known, and have not been made since.
    ///
    /// Few bases lie in the same place of their blocks, so that a processor would guess wrong: blocks are chosen without branches, once for all
    /// offsets that share a coordinate.
    #[inline(always)]
    pub(super) fn address(&self, offset: [i64; MAX_AXES], steps: &PerAxis, back: &[usize; 8]) -> *mut u8 {
        let block = |corner: usize| self.blocks[corner].wrapping_sub(back[corner]);
        let choose = |axis: usize, next: *mut u8, here: *mut u8| {
            core::hint::select_unpredictable(offset[axis] >= self.edge[axis], next, here)
        };
        let mut address = choose(0, block(1), block(0));
        if const { X::RANK > 1 } {
            address = choose(1, choose(0, block(3), block(2)), address);
        }
        if const { X::RANK > 2 } {
            let (low, high) = (choose(0, block(5), block(4)), choose(0, block(7), block(6)));
            address = choose(2, choose(1, high, low), address);
        }
        for_axes!(X, A => {
            address = address.wrapping_add(self.inner[A].wrapping_add(offset[A]).wrapping_mul(steps[A] as i64) as usize);
        });
        address
    }

    /// The block at an offset in the box of whoever the blocks around are of. They are known.
    #[inline(always)]
    pub(super) fn corner(&self, offset: [i64; MAX_AXES]) -> *mut u8 {
        self.corners.get(self.set, self.corner_of(offset))
    }

    /// Notes the block at an offset in the box, which has been made since. The blocks around are known.
    #[inline(always)]
    pub(super) fn learn(&self, offset: [i64; MAX_AXES], block: *mut u8) {
        self.corners.put(self.set, self.corner_of(offset), block);
    }

    /// `base + offset` where the offset is known to lie in the box.
    #[inline(always)]
    pub(super) fn plus_held(&self, offset: [i64; MAX_AXES]) -> [u32; MAX_AXES] {
        let mut place = [0; MAX_AXES];
        for_axes!(X, A => place[A] = self.base[A].wrapping_add(offset[A] as u32));
        place
    }

    /// `base + offset` where the offset lies beyond the box: the sum is checked by itself.
    #[cold]
    #[inline(never)]
    #[track_caller]
    pub(super) fn far(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        let place = per_axis(|a| i64::from(self.base[a] as i32).saturating_add(offset[a]));
        inside::<X>(place, &self.shape).unwrap_or_else(|| {
            let at = per_axis(|a| place[a].saturating_add(i64::from(self.origin[a])));
            site.missed(&at[..X::RANK], &self.shape[..X::RANK], &self.origin[..X::RANK])
        })
    }
}
