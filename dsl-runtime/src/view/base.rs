//! A base index checked once for all constant offsets of a stencil.

use core::cell::Cell;
use core::marker::PhantomData;

use super::Site;
use crate::axes::{Axes, MAX_AXES, all, per_axis};
use crate::field::Handle;
use crate::index::inside;
use crate::layout::{Block, Geometry, Layout};
use crate::record::Record;
use crate::scatter::Window;

/// A base whose whole box of offsets lies within a field's indices.
#[doc(hidden)]
#[derive(Debug)]
pub struct Based<'b, L: Layout<X>, X: Axes> {
    /// The base's place; in wrapping arithmetic, since its own cell may lie below zero.
    base: [u32; MAX_AXES],
    low: [i32; MAX_AXES],
    high: [i32; MAX_AXES],
    /// The field that was checked. The macro uses a base for the field that it was made from alone.
    shape: [u32; MAX_AXES],
    origin: [i32; MAX_AXES],
    /// The blocks around, of a sparse field.
    corners: &'b L::Corners,
    /// Whether they are known, and whose they are.
    known: bool,
    root: *mut u8,
    /// The offset along each axis at which the next block begins.
    edge: [i64; 3],
    axes: PhantomData<X>,
}

/// The blocks around a base, the first of them and the next along each axis, kept until a base has another first block.
#[doc(hidden)]
pub trait Corners: Default + core::fmt::Debug + 'static {
    /// Makes them those around `first`. They stay what they are where that was the last, and no block was made since by the job, which
    /// `grown` tells: 0 where it is not known.
    fn seek(&self, first: &Block, grown: u32, find: impl FnOnce() -> [*mut u8; 8]);
    /// The block beside the first along those axes `a` whose bit `1 << a` is set.
    fn get(&self, corner: usize) -> *mut u8;
    /// Puts another there, which has just been made.
    fn put(&self, corner: usize, block: *mut u8);
}
impl Corners for () {
    #[inline(always)]
    fn seek(&self, _: &Block, _: u32, _: impl FnOnce() -> [*mut u8; 8]) {}
    #[inline(always)]
    fn get(&self, _: usize) -> *mut u8 {
        core::ptr::null_mut()
    }
    fn put(&self, _: usize, _: *mut u8) {}
}

/// The blocks around a base of a sparse field of up to three axes.
#[doc(hidden)]
#[derive(Debug)]
pub struct EightCorners {
    first: Cell<Block>,
    grown: Cell<u32>,
    blocks: Cell<[*mut u8; 8]>,
}
impl Default for EightCorners {
    #[inline(always)]
    fn default() -> Self {
        let blocks = [core::ptr::null_mut(); 8];
        Self { first: Cell::new([0; MAX_AXES]), grown: Cell::new(0), blocks: Cell::new(blocks) }
    }
}
impl Corners for EightCorners {
    #[inline(always)]
    fn seek(&self, first: &Block, grown: u32, find: impl FnOnce() -> [*mut u8; 8]) {
        if grown == 0 || self.grown.get() != grown || self.first.get() != *first {
            self.blocks.set(find());
            self.first.set(*first);
            self.grown.set(grown);
        }
    }
    #[inline(always)]
    fn get(&self, corner: usize) -> *mut u8 {
        self.blocks.as_array_of_cells()[corner % 8].get()
    }
    #[inline(always)]
    fn put(&self, corner: usize, block: *mut u8) {
        self.blocks.as_array_of_cells()[corner % 8].set(block);
    }
}

impl<'b, L: Layout<X>, X: Axes> Based<'b, L, X> {
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
        let wide = |offsets: [i64; N]| {
            let mut all = [0; MAX_AXES];
            all[..N].copy_from_slice(&offsets);
            all
        };
        Self::around(geometry, window, corners, base, wide(low), wide(high))
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
        let fits = all::<X>(
            #[inline(always)]
            |a| {
                // `base` came from integers of at most 64 bits: extremes must not wrap around.
                let (first, last) = (base[a].saturating_add(low[a]), base[a].saturating_add(high[a]));
                let (start, end) = window.span(geometry, a);
                (first >= start) & (last < end)
            },
        );
        let narrow = |offsets: [i64; MAX_AXES]| {
            per_axis(
                #[inline(always)]
                |a| if a < X::RANK { offsets[a] as i32 } else { 0 },
            )
        };
        fits.then(
            #[inline(always)]
            || Self {
                base: geometry.place(base),
                low: narrow(low),
                high: narrow(high),
                shape,
                origin,
                corners,
                known: false,
                root: core::ptr::null_mut(),
                edge: [0; 3],
                axes: PhantomData,
            },
        )
    }

    /// Finds the blocks around the base.
    #[inline(always)]
    pub(super) fn cornered<R: Record>(mut self, handle: &Handle<'_, R, L, X>) -> Self {
        if const { !(L::CHAIN.is_sparse() && L::BRANCHES == 1 && X::RANK <= 3) } {
            return self;
        }
        let extent = |a: usize| const { L::CHAIN.extent }[a] as u32;
        // A wider box reaches more than one further block.
        if !all::<X>(|a| self.high[a].wrapping_sub(self.low[a]) as u32 <= extent(a)) {
            return self;
        }
        let start = |a: usize| self.base[a].wrapping_add_signed(self.low[a]);
        let first = per_axis(|a| if a < X::RANK { start(a) / extent(a) } else { 0 });
        let edge = |a: usize| i64::from(self.low[a]) + i64::from(extent(a) - start(a) % extent(a));
        self.edge = core::array::from_fn(|a| if a < X::RANK { edge(a) } else { i64::MAX });
        (self.known, self.root) = (true, handle.root);
        handle.around(self.corners, first);
        self
    }

    /// Whether an offset lies in the box.
    #[inline(always)]
    pub(super) fn holds(&self, offset: [i64; MAX_AXES]) -> bool {
        all::<X>(
            #[inline(always)]
            |a| (offset[a] >= i64::from(self.low[a])) & (offset[a] <= i64::from(self.high[a])),
        )
    }

    /// Which of the blocks around the offset lies in.
    #[inline(always)]
    fn corner_of(&self, offset: [i64; MAX_AXES]) -> usize {
        let next = |a: usize| usize::from(offset[a] >= self.edge[a]) << a;
        next(0) | next(1) | next(2)
    }

    /// Whether the blocks around, where they are known, are those of a root: the field's, or that of a job's copy of it.
    #[inline(always)]
    pub(super) fn is_of(&self, root: *mut u8) -> bool {
        !self.known || core::ptr::eq(root, self.root)
    }

    /// The block at an offset of whoever the blocks around are of, where they are known.
    #[inline(always)]
    pub(super) fn corner(&self, offset: [i64; MAX_AXES]) -> Option<*mut u8> {
        (self.known && self.holds(offset)).then(
            #[inline(always)]
            || self.corners.get(self.corner_of(offset)),
        )
    }

    /// Notes the block at an offset, which has been made since.
    #[inline(always)]
    pub(super) fn learn(&self, offset: [i64; MAX_AXES], block: *mut u8) {
        if self.known && self.holds(offset) {
            self.corners.put(self.corner_of(offset), block);
        }
    }

    /// `base + offset` where the offset lies in the box, which folds to nothing for unrolled offsets. Otherwise the sum
    /// is checked by itself.
    #[inline(always)]
    #[track_caller]
    pub(super) fn plus(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        if self.holds(offset) { self.plus_held(offset) } else { self.far(offset, site) }
    }

    /// `base + offset` where the offset is known to lie in the box.
    #[inline(always)]
    pub(super) fn plus_held(&self, offset: [i64; MAX_AXES]) -> [u32; MAX_AXES] {
        per_axis(
            #[inline(always)]
            |a| if a < X::RANK { self.base[a].wrapping_add(offset[a] as u32) } else { 0 },
        )
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn far(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        let place = per_axis(|a| i64::from(self.base[a] as i32).saturating_add(offset[a]));
        inside::<X>(place, &self.shape).unwrap_or_else(|| {
            let at = per_axis(|a| place[a].saturating_add(i64::from(self.origin[a])));
            site.missed(&at[..X::RANK], &self.shape[..X::RANK], &self.origin[..X::RANK])
        })
    }
}
