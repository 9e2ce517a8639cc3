//! What a parallel loop runs over: a box of a field, in the order of its memory, or ranges of integers.

use core::marker::PhantomData;
use core::ops::Range;

use super::run::Run;
use crate::axes::{Axes, I, Ij, Ijk, Ijkl, MAX_AXES, PerAxis, all, per_axis};
use crate::element::Sealed;
use crate::index::Integer;
use crate::layout::node::{Chained, order, rows};
use crate::layout::{Chain, Digit, Geometry, Layout, Map};
use crate::record::{ElementList, Path, Record, Whole};
use crate::scatter::Piece;
use crate::store::active::ActiveList;
use crate::view::{HELD, Places, View};
use std::sync::Arc;

/// What a parallel loop runs over. The list is closed: each element is visited exactly once.
#[doc(hidden)]
pub trait Space: Copy + Send + Sync + Sealed + 'static {
    /// How many loop variables there are.
    const RANK: usize;
    /// What one loop variable for all axes is.
    type Index: Copy;
    /// The loop variables as a tuple.
    type Tuple: Copy;
    /// The axis along which runs lie.
    const AXIS: usize;
    /// The length of whole runs, where it is a constant; else 0.
    const RUN: usize;
    /// Cells of a block along each axis; all 1 where there are none.
    const EXTENT: PerAxis;
    /// The arrangement of the blocks.
    const DIGITS: &'static [Digit];
    /// Whether blocks are found through the loop's field alone.
    const SPARSE: bool = false;
    /// Whether a light loop gets whole runs in which a mask tells the active elements.
    const MASKED: bool = false;
    /// The branch of the loop's field.
    const BRANCH: usize = 0;
    /// Whether [`part`](Self::part) is available.
    const DIVISIBLE: bool;
    /// Elements in all.
    fn elements(&self) -> usize;
    /// What is dealt out to threads: blocks, or elements where there are none.
    fn units(&self) -> usize;
    /// The box in logical coordinates: its first element and the one after its last.
    fn bounds(&self) -> ([i64; MAX_AXES], [i64; MAX_AXES]);
    /// The origin of the loop's field; zero where there is none.
    fn origin(&self) -> [i32; MAX_AXES];
    /// Visits the runs of some units in memory order; `LIGHT` writes whole runs out apart from cut ones.
    fn visit<const LIGHT: bool>(&self, units: Range<usize>, fits: bool, run: impl FnMut(Run<'_, Self>));
    /// Fetches what the first element of a piece holds into the caches, where that is worth it.
    #[inline(always)]
    fn prefetch(&self, _: Piece) {}
    /// The elements of a piece alone. Numbers count along the run axis first, then along the other axes, the last of them first.
    fn part(&self, piece: Piece) -> Self;
    /// The loop's variable at coordinates.
    fn index(at: [i64; MAX_AXES]) -> Self::Index;
    /// The loop's variables at coordinates.
    fn tuple(at: [i64; MAX_AXES]) -> Self::Tuple;

    /// Whether a field has the origin of the loop's, where its blocks are arranged as those of the loop's field: rows step through
    /// both at once.
    ///
    /// Also an unchecked launch must ask this: it is no question of a bound.
    fn aligned<R: Record, L: Layout<X>, X: Axes, const WRITE: bool>(&self, field: View<'_, R, L, X, WRITE>) -> bool {
        !const { any_in_blocks::<Self, L, X>() } || self.origin() == field.handle.geometry.origin
    }

    /// Whether the whole box, moved by the offsets `low` to `high`, lies within a field, and its blocks are
    /// [`aligned`](Self::aligned). No offsets mean zeros.
    fn fits<const N: usize, R: Record, L: Layout<X>, X: Axes, const WRITE: bool>(
        &self,
        field: View<'_, R, L, X, WRITE>,
        low: [i64; N],
        high: [i64; N],
    ) -> bool {
        const { assert!(N == 0 || N == X::RANK, "as many offsets as the field has axes") }
        let (first, end) = self.bounds();
        let Geometry { shape, origin, .. } = &field.handle.geometry;
        let within = |a: usize| {
            let (low, high) = if N == 0 { (0, 0) } else { (low[a], high[a]) };
            let (first, end) = (first[a].saturating_add(low), end[a].saturating_add(high));
            let start = i64::from(origin[a]);
            first >= start && end <= start + i64::from(shape[a])
        };
        Self::RANK == X::RANK && (self.elements() == 0 || ((0..X::RANK).all(within) && self.aligned(field)))
    }

    /// Whether indices in which the loop's variables stand so lie within a field, for the whole box.
    fn holds<A: Places, R: Record, L: Layout<X>, X: Axes, const WRITE: bool>(
        &self,
        field: View<'_, R, L, X, WRITE>,
        places: A,
    ) -> bool {
        let (first, end) = self.bounds();
        let extremes = places.extremes(&first, &end);
        let Geometry { shape, origin, .. } = &field.handle.geometry;
        let within = |a: usize| {
            let start = i64::from(origin[a]);
            extremes[a].0 >= start && extremes[a].1 < start + i64::from(shape[a])
        };
        self.elements() == 0 || (0..X::RANK).all(within)
    }
}

/// Where a piece of a box begins, in elements from the box's first, when those along `axis` are counted first.
#[inline(always)]
fn start_of<X: Axes>(piece: Piece, axis: usize, extent: impl Fn(usize) -> usize) -> PerAxis {
    let mut start = [0; MAX_AXES];
    let mut rest = piece.first as usize;
    if const { X::RANK > 1 } {
        start[axis] = rest % extent(axis);
        rest /= extent(axis);
        for a in (0..X::RANK).rev().filter(|&a| a != axis) {
            start[a] = rest % extent(a);
            rest /= extent(a);
        }
    } else {
        start[axis] = rest;
    }
    start
}

/// What runs have for a block that is found by its place alone.
const NOWHERE: *mut u8 = core::ptr::null_mut();

/// Whether rows of a branch step through the blocks of a loop's field, which are arranged as its own.
pub(crate) const fn is_in_blocks<S: Space>(chain: &Chain) -> bool {
    S::RUN > 0 && !chain.is_flat() && same(S::DIGITS, chain.digits)
}

/// Whether those of any branch of a layout do.
pub(crate) const fn any_in_blocks<S: Space, L: Layout<X>, X: Axes>() -> bool {
    S::RANK == X::RANK && (is_in_blocks::<S>(&L::CHAIN) || (L::BRANCHES > 1 && any_in_blocks::<S, L::Rest, X>()))
}

const fn same(a: &[Digit], b: &[Digit]) -> bool {
    if a.len() != b.len() {
        return false;
    }
    let mut n = 0;
    while n < a.len() {
        let mut axis = 0;
        while axis < MAX_AXES {
            if a[n].sizes[axis] != b[n].sizes[axis] {
                return false;
            }
            axis += 1;
        }
        // Order 0 marks the end of a list.
        if a[n].order != b[n].order || a[n].curve != b[n].curve || (n + 1 == a.len() && a[n].order != 0) {
            return false;
        }
        n += 1;
    }
    true
}

/// The most members of an element that are fetched ahead.
const MOST_FETCHED: usize = 8;

/// Asks for a cache line.
#[inline(always)]
fn fetch(address: *const u8) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    // SAFETY: a hint: nothing is read, and any address will do.
    unsafe {
        core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(address.cast());
    }
    #[cfg(not(all(target_arch = "x86_64", not(miri))))]
    let _ = address;
}

/// A box of a field, in the order of the memory of the branch that holds the path `P`.
#[doc(hidden)]
pub struct Cells<R, L, X, P> {
    /// The first index of the field.
    origin: [i32; MAX_AXES],
    /// The box in places.
    pub(super) first: [u32; MAX_AXES],
    pub(super) end: [u32; MAX_AXES],
    /// The same in the root's cells.
    first_block: PerAxis,
    blocks: PerAxis,
    /// The active elements (sparse branches; else null), and the field's memory.
    active: Active,
    /// How the field lies in memory.
    geometry: Geometry,
    /// Whether all active blocks lie in the box as a whole.
    pub(super) all_inside: bool,
    types: PhantomData<(Types<R, L>, Types<X, P>)>,
}

/// The active elements of a loop's field when the loop began.
///
/// The field keeps the list until it is borrowed exclusively again: beyond the end of the loop.
#[derive(Clone, Copy, Debug)]
struct Active {
    list: *const ActiveList,
    root: *mut u8,
}
// SAFETY: the list is read alone.
unsafe impl Send for Active {}
// SAFETY: as above.
unsafe impl Sync for Active {}

impl Active {
    #[inline(always)]
    fn list(&self) -> Option<&ActiveList> {
        // SAFETY: null, or a list that the field keeps for as long as the space is used.
        unsafe { self.list.as_ref() }
    }

    /// Whether all active blocks, each of so many elements, lie in `first..end` along an axis.
    fn is_inside(&self, axis: usize, extent: u32, first: u32, end: u32) -> bool {
        let at = |block: u64| block.saturating_mul(extent.into());
        self.list().is_some_and(|list| at(list.first[axis]) >= first.into() && at(list.end[axis]) <= end.into())
    }

    /// The part of `first..end` along an axis in which active blocks lie, each of so many elements.
    fn clipped(&self, axis: usize, extent: u32, first: u32, end: u32) -> (u32, u32) {
        let Some(list) = self.list() else { return (first, end) };
        let at = |block: u64| block.saturating_mul(extent.into()).min(u64::from(u32::MAX)) as u32;
        let first = first.max(at(list.first[axis])).min(end);
        (first, end.min(at(list.end[axis])).max(first))
    }
}

/// Types that are named alone.
type Types<A, B> = fn() -> (A, B);

impl<R, L, X, P> Clone for Cells<R, L, X, P> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P> Copy for Cells<R, L, X, P> {}
impl<R, L, X, P> core::fmt::Debug for Cells<R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Cells({:?}..{:?})", self.first, self.end)
    }
}

impl<R, L, X, P> Sealed for Cells<R, L, X, P> {}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Chained<X> for Cells<R, L, X, P> {
    const CHAIN: &'static Chain = Map::<R, L, X>::chain(P::OFFSET);
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Cells<R, L, X, P> {
    fn new(geometry: Geometry, border: u32, active: Active) -> Self {
        let branch = Map::<R, L, X>::geometry(&geometry, P::OFFSET);
        let mut this = Self {
            origin: branch.origin,
            first: [0; MAX_AXES],
            end: [1; MAX_AXES],
            first_block: [0; MAX_AXES],
            blocks: [1; MAX_AXES],
            active,
            geometry,
            all_inside: true,
            types: PhantomData,
        };
        for axis in 0..X::RANK {
            let extent = const { &<Self as Space>::EXTENT }[axis] as u32;
            let size = branch.shape[axis];
            let first = border.min(size);
            let end = size.saturating_sub(border).max(first);
            this.all_inside &= active.is_inside(axis, extent, first, end);
            let (first, end) = active.clipped(axis, extent, first, end);
            this.narrow(axis, first, end);
        }
        this
    }

    /// Makes the box `first..end` along an axis.
    #[inline(always)]
    fn narrow(&mut self, axis: usize, first: u32, end: u32) {
        let extent = const { &<Self as Space>::EXTENT }[axis] as u32;
        (self.first[axis], self.end[axis]) = (first, end);
        self.first_block[axis] = (first / extent) as usize;
        self.blocks[axis] = if end > first { end.div_ceil(extent) as usize - self.first_block[axis] } else { 0 };
    }

    /// The active elements (sparse branches).
    #[inline(always)]
    pub(super) fn active_list(&self) -> Option<&ActiveList> {
        self.active.list()
    }

    /// The field's memory.
    #[inline(always)]
    pub(super) fn root(&self) -> *mut u8 {
        self.active.root
    }

    /// The axes in the order of memory, those that the root does not name (which have one block) first.
    const ORDER: ([usize; MAX_AXES], usize) = {
        let (named, count) = order::<X>(<Self as Chained<X>>::CHAIN.root);
        let (mut axes, mut n, mut axis) = ([0; MAX_AXES], 0, 0);
        while axis < X::RANK {
            let (mut is_named, mut m) = (false, 0);
            while m < count {
                is_named |= named[m] == axis;
                m += 1;
            }
            if !is_named {
                axes[n] = axis;
                n += 1;
            }
            axis += 1;
        }
        let mut m = 0;
        while m < count {
            axes[n + m] = named[m];
            m += 1;
        }
        (axes, n + count)
    };
    /// The root's fastest axis.
    const FASTEST: usize = Self::ORDER.0[Self::ORDER.1 - 1];

    /// Whether block `b` lies in the box along an axis.
    #[inline(always)]
    fn whole(&self, axis: usize, b: usize) -> bool {
        let extent = const { &<Self as Space>::EXTENT }[axis] as u32;
        let start = b as u32 * extent;
        axis >= X::RANK || (start >= self.first[axis] && start + extent <= self.end[axis])
    }

    /// Visits the runs of a row of blocks, beginning at `block`, along the root's fastest axis.
    #[inline(always)]
    fn blocks<const LIGHT: bool>(&self, block: PerAxis, len: usize, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        let last = Self::FASTEST;
        let beside = all::<X>(
            #[inline(always)]
            |a| a == last || self.whole(a, block[a]),
        );
        let nth = |b: usize| {
            per_axis(
                #[inline(always)]
                |a| if a == last { b } else { block[a] },
            )
        };
        // Whole blocks lie in the middle, cut ones at the ends of the row.
        let (first, end) = (block[last], block[last] + len);
        let extent = const { <Self as Space>::EXTENT[Self::FASTEST] };
        let whole = (self.first[last] as usize).div_ceil(extent).clamp(first, end);
        let cut = if const { LIGHT } && beside { (self.end[last] as usize / extent).clamp(whole, end) } else { whole };
        let mut b = first;
        while b < end {
            if const { !LIGHT } || b < whole || b >= cut {
                self.cut_block(nth(b), fits, run);
                b += 1;
            } else {
                while b < cut {
                    self.block(nth(b), fits, run);
                    b += 1;
                }
            }
        }
    }

    /// Visits the runs of a block that lies in the box, each of constant length.
    #[inline(always)]
    fn block(&self, block: PerAxis, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        rows::<Self, X>(
            #[inline(always)]
            |inner| {
                let (at, len) = (self.start(block, inner), <Self as Space>::RUN);
                run(Run {
                    at,
                    first: 0,
                    len,
                    block,
                    inner,
                    brick: NOWHERE,
                    root: NOWHERE,
                    whole: true,
                    fits,
                    mask: None,
                    next: None,
                    owner: PhantomData,
                });
            },
        );
    }

    /// Visits the runs of a block as far as they lie in the box.
    #[inline(always)]
    fn cut_block(&self, block: PerAxis, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        let (axis, length) = (<Self as Space>::AXIS, <Self as Space>::RUN as i64);
        for r in 0..const { <Self as Chained<X>>::CHAIN.rows } {
            let inner = Self::row_place(r);
            let place = Self::place(block, inner);
            let inside = all::<X>(
                #[inline(always)]
                |a| a == axis || (place[a] >= i64::from(self.first[a]) && place[a] < i64::from(self.end[a])),
            );
            let first = (i64::from(self.first[axis]) - place[axis]).max(0);
            let end = (i64::from(self.end[axis]) - place[axis]).min(length);
            if inside && first < end {
                let (first, len) = (first as usize, (end - first) as usize);
                let at = self.start(block, inner);
                run(Run {
                    at,
                    first,
                    len,
                    block,
                    inner,
                    brick: NOWHERE,
                    root: NOWHERE,
                    whole: false,
                    fits,
                    mask: None,
                    next: None,
                    owner: PhantomData,
                });
            }
        }
    }

    /// Visits the runs of some units. The visitor is borrowed: if it was owned, each call would have code that drops it should the call unwind.
    #[inline(always)]
    fn visit_by<const LIGHT: bool>(&self, units: Range<usize>, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        if units.is_empty() {
            return;
        }
        if const { Self::SPARSE } {
            self.visit_active::<LIGHT>(units, fits, run);
            return;
        }
        let (axes, count) = const { Self::ORDER };
        let last = const { Self::FASTEST };
        let mut block = [0; MAX_AXES];
        let mut rest = units.start;
        for &axis in axes[..count].iter().rev() {
            block[axis] = rest % self.blocks[axis];
            rest /= self.blocks[axis];
        }
        let mut left = units.len();
        while left > 0 {
            let len = (self.blocks[last] - block[last]).min(left);
            let first = per_axis(
                #[inline(always)]
                |a| self.first_block[a] + block[a],
            );
            if const { <Self as Chained<X>>::CHAIN.is_flat() } {
                let (at, inner) = (self.start(first, [0; MAX_AXES]), [0; MAX_AXES]);
                run(Run {
                    at,
                    first: 0,
                    len,
                    block: first,
                    inner,
                    brick: NOWHERE,
                    root: NOWHERE,
                    whole: false,
                    fits,
                    mask: None,
                    next: None,
                    owner: PhantomData,
                });
            } else {
                self.blocks::<LIGHT>(first, len, fits, run);
            }
            left -= len;
            block[last] = 0;
            for &axis in axes[..count - 1].iter().rev() {
                block[axis] += 1;
                if block[axis] < self.blocks[axis] {
                    break;
                }
                block[axis] = 0;
            }
        }
    }

    /// The logical coordinates of a cell of a block.
    #[inline(always)]
    pub(super) fn start(&self, block: PerAxis, inner: PerAxis) -> [i64; MAX_AXES] {
        let place = Self::place(block, inner);
        per_axis(
            #[inline(always)]
            |a| place[a] + i64::from(self.origin[a]),
        )
    }

    /// The place of a cell of a block.
    #[inline(always)]
    pub(super) fn place(block: PerAxis, inner: PerAxis) -> [i64; MAX_AXES] {
        per_axis(
            #[inline(always)]
            |a| if a < X::RANK { (block[a] * const { &<Self as Space>::EXTENT }[a] + inner[a]) as i64 } else { 0 },
        )
    }
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Space for Cells<R, L, X, P> {
    const RANK: usize = X::RANK;
    type Index = X::Index;
    type Tuple = X::Tuple;
    const AXIS: usize = <Self as Chained<X>>::CHAIN.run_axis;
    const RUN: usize = <Self as Chained<X>>::CHAIN.run;
    const EXTENT: PerAxis = <Self as Chained<X>>::CHAIN.extent;
    const DIGITS: &'static [Digit] = <Self as Chained<X>>::CHAIN.digits;
    const SPARSE: bool = <Self as Chained<X>>::CHAIN.is_sparse();
    const MASKED: bool = Self::GRAIN == 1 && Self::RUN <= HELD;
    const BRANCH: usize = Map::<R, L, X>::branch(P::OFFSET);
    const DIVISIBLE: bool = !Self::SPARSE;

    fn elements(&self) -> usize {
        if let Some(list) = self.active.list() {
            return list.work();
        }
        (0..X::RANK).map(|a| (self.end[a] - self.first[a]) as usize).product()
    }

    fn units(&self) -> usize {
        if let Some(list) = self.active.list() {
            return list.work();
        }
        self.blocks[..X::RANK].iter().product()
    }

    fn bounds(&self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        let logical = |places: [u32; MAX_AXES]| per_axis(|a| i64::from(places[a]) + i64::from(self.origin[a]));
        (logical(self.first), logical(self.end))
    }

    fn origin(&self) -> [i32; MAX_AXES] {
        self.origin
    }

    #[inline(always)]
    fn visit<const LIGHT: bool>(&self, units: Range<usize>, fits: bool, mut run: impl FnMut(Run<'_, Self>)) {
        self.visit_by::<LIGHT>(units, fits, &mut run);
    }

    #[inline(always)]
    fn prefetch(&self, piece: Piece) {
        // Elements of a line come from anywhere when they are sorted by another field's tiles; those of a box lie in rows of it.
        if const { X::RANK != 1 || Self::SPARSE } {
            return;
        }
        let place = per_axis(|a| if a == 0 { self.first[0].wrapping_add(piece.first) } else { 0 });
        let members = const { <P::Value as Record>::Elements::MEMBERS.len() };
        for m in P::OFFSET..P::OFFSET + members.min(MOST_FETCHED) {
            fetch(self.active.root.wrapping_add(Map::<R, L, X>::offset(&self.geometry, m, place)));
        }
    }

    #[inline(always)]
    fn part(&self, piece: Piece) -> Self {
        let axis = const { <Self as Space>::AXIS };
        let start = start_of::<X>(piece, axis, |a| (self.end[a] - self.first[a]) as usize);
        let mut part = *self;
        for (a, &start) in start.iter().enumerate().take(X::RANK) {
            let first = self.first[a] + start as u32;
            part.narrow(a, first, first + if a == axis { piece.len } else { 1 });
        }
        part
    }

    #[inline(always)]
    fn index(at: [i64; MAX_AXES]) -> X::Index {
        X::index([at[0] as i32, at[1] as i32, at[2] as i32, at[3] as i32])
    }

    #[inline(always)]
    fn tuple(at: [i64; MAX_AXES]) -> X::Tuple {
        X::tuple([at[0] as i32, at[1] as i32, at[2] as i32, at[3] as i32])
    }
}

/// All elements of a field.
#[doc(hidden)]
pub fn over<R: Record, L: Layout<X>, X: Axes, const WRITE: bool>(
    field: View<'_, R, L, X, WRITE>,
) -> Cells<R, L, X, Whole> {
    of_branch(field, Whole, 0)
}

/// All elements of a field but a border of `width`.
#[doc(hidden)]
pub fn interior<R: Record, L: Layout<X>, X: Axes, const WRITE: bool>(
    field: View<'_, R, L, X, WRITE>,
    width: u32,
) -> Cells<R, L, X, Whole> {
    of_branch(field, Whole, width)
}

/// All elements of a field but a border of `width`, in the order of the branch that holds a path.
#[doc(hidden)]
pub fn of_branch<R: Record, L: Layout<X>, X: Axes, P: Path<R>, const WRITE: bool>(
    field: View<'_, R, L, X, WRITE>,
    _: P,
    width: u32,
) -> Cells<R, L, X, P> {
    const {
        assert!(
            Map::<R, L, X>::is_one_branch(P::OFFSET, <P::Value as Record>::Elements::MEMBERS.len()),
            "a loop over a field whose members stand in several branches names the branch by a member: `for ij in grid.m`"
        )
    }
    let active = match const { Map::<R, L, X>::is_sparse(P::OFFSET) } {
        true => Active { list: Arc::as_ptr(&field.handle.actives(P::OFFSET)), root: field.handle.root },
        false => Active { list: core::ptr::null(), root: field.handle.root },
    };
    Cells::new(field.handle.geometry, width, active)
}

/// A box of integers, its last axis fastest.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Ranges<T, X> {
    first: [i64; MAX_AXES],
    end: [i64; MAX_AXES],
    types: PhantomData<fn() -> (T, X)>,
}

impl<T, X> Sealed for Ranges<T, X> {}

/// A tuple of integers: the loop variables of ranges.
#[doc(hidden)]
pub trait Integers: Copy + 'static {
    /// As many axes.
    type X: Axes;
    /// The one loop variable, where there is one; else the tuple.
    type One: Copy;
    /// The variables of these values.
    fn narrow(at: [i64; MAX_AXES]) -> Self;
    /// The one variable of these values.
    fn one(at: [i64; MAX_AXES]) -> Self::One;
}

impl<T: Integer> Integers for (T,) {
    type X = I;
    type One = T;
    #[inline(always)]
    fn narrow(at: [i64; MAX_AXES]) -> Self {
        (T::narrow(at[0]),)
    }
    #[inline(always)]
    fn one(at: [i64; MAX_AXES]) -> T {
        T::narrow(at[0])
    }
}
impl<T: Integer, U: Integer> Integers for (T, U) {
    type X = Ij;
    type One = Self;
    #[inline(always)]
    fn narrow(at: [i64; MAX_AXES]) -> Self {
        (T::narrow(at[0]), U::narrow(at[1]))
    }
    #[inline(always)]
    fn one(at: [i64; MAX_AXES]) -> Self {
        Self::narrow(at)
    }
}
impl<T: Integer, U: Integer, V: Integer> Integers for (T, U, V) {
    type X = Ijk;
    type One = Self;
    #[inline(always)]
    fn narrow(at: [i64; MAX_AXES]) -> Self {
        (T::narrow(at[0]), U::narrow(at[1]), V::narrow(at[2]))
    }
    #[inline(always)]
    fn one(at: [i64; MAX_AXES]) -> Self {
        Self::narrow(at)
    }
}

impl<T: Integer, U: Integer, V: Integer, W: Integer> Integers for (T, U, V, W) {
    type X = Ijkl;
    type One = Self;
    #[inline(always)]
    fn narrow(at: [i64; MAX_AXES]) -> Self {
        (T::narrow(at[0]), U::narrow(at[1]), V::narrow(at[2]), W::narrow(at[3]))
    }
    #[inline(always)]
    fn one(at: [i64; MAX_AXES]) -> Self {
        Self::narrow(at)
    }
}

/// A tuple of ranges: the head of a loop without a field.
#[doc(hidden)]
pub trait RangeTuple {
    /// The loop variables.
    type Integers: Integers;
    /// The ranges' ends.
    fn bounds(self) -> ([i64; MAX_AXES], [i64; MAX_AXES]);
}
impl<T: Integer> RangeTuple for (Range<T>,) {
    type Integers = (T,);
    fn bounds(self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        ([self.0.start.wide(), 0, 0, 0], [self.0.end.wide(), 1, 1, 1])
    }
}
impl<T: Integer, U: Integer> RangeTuple for (Range<T>, Range<U>) {
    type Integers = (T, U);
    fn bounds(self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        ([self.0.start.wide(), self.1.start.wide(), 0, 0], [self.0.end.wide(), self.1.end.wide(), 1, 1])
    }
}
impl<T: Integer, U: Integer, V: Integer> RangeTuple for (Range<T>, Range<U>, Range<V>) {
    type Integers = (T, U, V);
    fn bounds(self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        (
            [self.0.start.wide(), self.1.start.wide(), self.2.start.wide(), 0],
            [self.0.end.wide(), self.1.end.wide(), self.2.end.wide(), 1],
        )
    }
}

impl<T: Integer, U: Integer, V: Integer, W: Integer> RangeTuple for (Range<T>, Range<U>, Range<V>, Range<W>) {
    type Integers = (T, U, V, W);
    fn bounds(self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        (
            [self.0.start.wide(), self.1.start.wide(), self.2.start.wide(), self.3.start.wide()],
            [self.0.end.wide(), self.1.end.wide(), self.2.end.wide(), self.3.end.wide()],
        )
    }
}

/// A box of integers.
///
/// # Panics
/// Where it holds more elements than memory could.
#[doc(hidden)]
pub fn range<T: RangeTuple>(ranges: T) -> Ranges<T::Integers, <T::Integers as Integers>::X> {
    let (first, mut end) = ranges.bounds();
    let mut elements = 1i64;
    for axis in 0..MAX_AXES {
        end[axis] = end[axis].max(first[axis]);
        let extent = end[axis].checked_sub(first[axis]);
        elements =
            extent.and_then(|n| elements.checked_mul(n)).expect("a loop's ranges count at most i64::MAX elements");
    }
    Ranges { first, end, types: PhantomData }
}

impl<T: Integers<X = X>, X: Axes> Space for Ranges<T, X> {
    const RANK: usize = X::RANK;
    type Index = T::One;
    type Tuple = T;
    const AXIS: usize = X::RANK - 1;
    const RUN: usize = 0;
    const EXTENT: PerAxis = [1; MAX_AXES];
    const DIGITS: &'static [Digit] = &[];
    const DIVISIBLE: bool = true;

    fn elements(&self) -> usize {
        (0..X::RANK).map(|a| (self.end[a] - self.first[a]) as usize).product()
    }

    fn units(&self) -> usize {
        self.elements()
    }

    fn bounds(&self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        (self.first, self.end)
    }

    fn origin(&self) -> [i32; MAX_AXES] {
        [0; MAX_AXES]
    }

    #[inline(always)]
    fn visit<const LIGHT: bool>(&self, units: Range<usize>, fits: bool, mut run: impl FnMut(Run<'_, Self>)) {
        if units.is_empty() {
            return;
        }
        let extent = |axis: usize| (self.end[axis] - self.first[axis]) as usize;
        let last = X::RANK - 1;
        let mut place = [0; MAX_AXES];
        let mut rest = units.start;
        for axis in (0..X::RANK).rev() {
            place[axis] = rest % extent(axis);
            rest /= extent(axis);
        }
        let mut left = units.len();
        while left > 0 {
            let len = (extent(last) - place[last]).min(left);
            let mut at = self.first;
            for axis in 0..X::RANK {
                at[axis] += place[axis] as i64;
            }
            let (block, inner) = ([0; MAX_AXES], [0; MAX_AXES]);
            run(Run {
                at,
                first: 0,
                len,
                block,
                inner,
                brick: NOWHERE,
                root: NOWHERE,
                whole: false,
                fits,
                mask: None,
                next: None,
                owner: PhantomData,
            });
            left -= len;
            place[last] = 0;
            for axis in (0..last).rev() {
                place[axis] += 1;
                if place[axis] < extent(axis) {
                    break;
                }
                place[axis] = 0;
            }
        }
    }

    #[inline(always)]
    fn part(&self, piece: Piece) -> Self {
        let axis = const { <Self as Space>::AXIS };
        let start = start_of::<X>(piece, axis, |a| (self.end[a] - self.first[a]) as usize);
        let mut part = *self;
        for (a, &start) in start.iter().enumerate().take(X::RANK) {
            part.first[a] += start as i64;
            part.end[a] = part.first[a] + if a == axis { i64::from(piece.len) } else { 1 };
        }
        part
    }

    #[inline(always)]
    fn index(at: [i64; MAX_AXES]) -> T::One {
        T::one(at)
    }

    #[inline(always)]
    fn tuple(at: [i64; MAX_AXES]) -> T {
        T::narrow(at)
    }
}
