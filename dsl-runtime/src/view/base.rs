//! A base index checked once for all constant offsets of a stencil.

use core::marker::PhantomData;

use super::Site;
use crate::axes::{Axes, MAX_AXES, all, per_axis};
use crate::field::Handle;
use crate::index::inside;
use crate::layout::{Block, Geometry, Layout};
use crate::record::Record;

/// A base whose whole box of offsets lies within a field's indices.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Based<L: Layout<X>, X: Axes> {
    /// The base's place; in wrapping arithmetic, since its own cell may lie below zero.
    base: [u32; MAX_AXES],
    low: [i32; MAX_AXES],
    high: [i32; MAX_AXES],
    /// The field that was checked. The macro uses a base for the field that it was made from alone.
    shape: [u32; MAX_AXES],
    origin: [i32; MAX_AXES],
    /// The blocks around, of a sparse field.
    corners: L::Corners,
    axes: PhantomData<X>,
}

/// The blocks around a base: those of its lowest offset and of the next along each axis.
#[doc(hidden)]
pub trait Corners: Copy + core::fmt::Debug + 'static {
    /// None.
    const NONE: Self;
    /// Whose blocks they are, the first of them, and all: those beside it along axis `a` at `1 << a`.
    fn set(&mut self, root: *mut u8, first: Block, blocks: [*mut u8; 8]);
    /// A block of whoever it is asked for; null where it is none of them.
    fn get(&self, root: *mut u8, block: &Block) -> *mut u8;
}
impl Corners for () {
    const NONE: Self = ();
    fn set(&mut self, _: *mut u8, _: Block, _: [*mut u8; 8]) {}
    #[inline(always)]
    fn get(&self, _: *mut u8, _: &Block) -> *mut u8 {
        core::ptr::null_mut()
    }
}

/// The blocks around a base of a sparse field of up to three axes.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct EightCorners {
    root: *mut u8,
    first: Block,
    blocks: [*mut u8; 8],
}
impl Corners for EightCorners {
    const NONE: Self = Self { root: core::ptr::null_mut(), first: [0; MAX_AXES], blocks: [core::ptr::null_mut(); 8] };
    #[inline(always)]
    fn set(&mut self, root: *mut u8, first: Block, blocks: [*mut u8; 8]) {
        *self = Self { root, first, blocks };
    }
    #[inline(always)]
    fn get(&self, root: *mut u8, block: &Block) -> *mut u8 {
        let by = per_axis(
            #[inline(always)]
            |a| block[a].wrapping_sub(self.first[a]),
        );
        if (by[0] | by[1] | by[2]) > 1 || by[3] != 0 || !core::ptr::eq(root, self.root) {
            return core::ptr::null_mut();
        }
        self.blocks[(by[0] | by[1] << 1 | by[2] << 2) as usize]
    }
}

impl<L: Layout<X>, X: Axes> Based<L, X> {
    #[inline(always)]
    pub(super) fn new<const N: usize>(
        geometry: &Geometry,
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
        Self::around(geometry, base, wide(low), wide(high))
    }

    /// The same with offsets for all axes that there could be.
    #[inline(always)]
    pub(super) fn around(
        geometry: &Geometry,
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
                let start = i64::from(origin[a]);
                (first >= start) & (last < start + i64::from(shape[a]))
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
                corners: Corners::NONE,
                axes: PhantomData,
            },
        )
    }

    /// Looks up the blocks around the base.
    #[inline(always)]
    pub(super) fn cornered<R: Record>(mut self, handle: &Handle<'_, R, L, X>) -> Self {
        if const { !(L::CHAIN.is_sparse() && L::BRANCHES == 1 && X::RANK <= 3) } {
            return self;
        }
        let extent = |a: usize| const { L::CHAIN.extent }[a] as u32;
        let end = |a: usize, offset: i32| self.base[a].wrapping_add_signed(offset) / extent(a);
        let first = per_axis(|a| if a < X::RANK { end(a, self.low[a]) } else { 0 });
        let last = per_axis(|a| if a < X::RANK { end(a, self.high[a]) } else { 0 });
        let mut blocks = [core::ptr::null_mut(); 8];
        for (corner, known) in blocks.iter_mut().enumerate().take(const { 1 << X::RANK }) {
            let steps = |a: usize| (corner >> a & 1) as u32;
            // A block beyond the last is asked for by no offset.
            if crate::axes::all::<X>(|a| first[a] + steps(a) <= last[a]) {
                *known = handle.brick(0, &per_axis(|a| first[a] + if a < X::RANK { steps(a) } else { 0 }));
            }
        }
        self.corners.set(handle.root, first, blocks);
        self
    }

    /// A block around the base, of the field or of a job's copy of it; null where it is not known.
    #[inline(always)]
    pub(super) fn corner(&self, root: *mut u8, block: &Block) -> *mut u8 {
        self.corners.get(root, block)
    }

    /// `base + offset` where the offset lies in the box, which folds to nothing for unrolled offsets. Otherwise the sum
    /// is checked by itself.
    #[inline(always)]
    #[track_caller]
    pub(super) fn plus(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        let inside = all::<X>(
            #[inline(always)]
            |a| (offset[a] >= i64::from(self.low[a])) & (offset[a] <= i64::from(self.high[a])),
        );
        if !inside {
            return self.far(offset, site);
        }
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
