//! Running over the active elements of a sparse field.

use core::marker::PhantomData;
use core::ops::Range;

use super::run::{Mask, Run};
use super::space::{Cells, Space};
use crate::axes::{Axes, MAX_AXES, PerAxis, all, per_axis};
use crate::layout::node::{Chained, rows};
use crate::layout::{Layout, Map};
use crate::record::{Path, Record};
use crate::store::active::{ActiveBrick, ActiveList, next_bit};

/// How many blocks ahead the first line of a block is asked for: blocks lie anywhere, which no processor foresees.
const AHEAD: usize = 4;

/// Bytes a cache line.
const LINE: usize = 64;

/// Asks for a line of memory, perhaps in vain.
#[inline(always)]
pub(crate) fn prefetch(at: *const u8) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    // SAFETY: a hint, which reads nothing.
    unsafe {
        core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(at.cast());
    }
    #[cfg(not(all(target_arch = "x86_64", not(miri))))]
    let _ = at;
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Cells<R, L, X, P> {
    /// Cells that share one activity bit; 0 where a block is active as a whole.
    pub(super) const GRAIN: usize = match &<Self as Chained<X>>::CHAIN.tree {
        Some(tree) => tree.grain,
        None => 0,
    };
    const LIST: bool = matches!(&<Self as Chained<X>>::CHAIN.tree, Some(tree) if tree.list.is_some());
    const ROWS: usize = <Self as Chained<X>>::CHAIN.rows;

    /// Cache lines a row of a block, all members counted; none where that is more than a loop might touch.
    const LINES: usize = {
        let lines = Map::<R, L, X>::block_bytes(P::OFFSET).div_ceil(LINE * Self::ROWS);
        if lines <= 2 { lines } else { 0 }
    };

    /// Visits the runs of some of the work, which is counted in the elements of active blocks.
    #[inline(always)]
    pub(super) fn visit_active<const LIGHT: bool>(
        &self,
        units: Range<usize>,
        fits: bool,
        run: &mut impl FnMut(Run<'_, Self>),
    ) {
        let Some(list) = self.active_list() else { return };
        let mut n = list.ends.partition_point(|&end| end <= units.start);
        while n < list.bricks.len() && list.start(n) < units.end {
            let (start, work) = (list.start(n), list.ends[n] - list.start(n));
            let (from, to) = (units.start.saturating_sub(start), (units.end - start).min(work));
            let brick = &list.bricks[n];
            if let Some(next) = list.bricks.get(n + AHEAD) {
                prefetch(next.start);
            }
            if const { Self::LIST } {
                self.entries(brick, from..to, fits, run);
            } else if const { LIGHT && Self::GRAIN == 0 } && from == 0 && to == work && self.is_inside(brick) {
                self.whole_brick(brick, fits, run);
            } else if const { LIGHT && <Self as Space>::MASKED } {
                let row = |part: usize| (part * Self::ROWS).div_ceil(work);
                self.masked_rows(list, n, row(from)..row(to), fits, run);
            } else {
                // Rows are dealt out in the proportion of the work: the same cut for the job before and for the one behind.
                let row = |part: usize| (part * Self::ROWS).div_ceil(work);
                self.rows_of::<LIGHT>(list, n, row(from)..row(to), fits, run);
            }
            n += 1;
        }
    }

    /// Whether a block lies in the loop's box.
    #[inline(always)]
    fn is_inside(&self, brick: &ActiveBrick) -> bool {
        self.all_inside || self.is_brick_inside(brick)
    }

    #[inline(always)]
    fn is_brick_inside(&self, brick: &ActiveBrick) -> bool {
        all::<X>(
            #[inline(always)]
            |a| {
                let extent = u64::from(const { &<Self as Space>::EXTENT }[a] as u32);
                let start = u64::from(brick.block[a]) * extent;
                a >= X::RANK || (start >= self.first[a].into() && start + extent <= self.end[a].into())
            },
        )
    }

    #[inline(always)]
    fn block_number(brick: &ActiveBrick) -> PerAxis {
        per_axis(
            #[inline(always)]
            |a| brick.block[a] as usize,
        )
    }

    /// Visits all runs of a block.
    #[inline(always)]
    fn whole_brick(&self, brick: &ActiveBrick, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        // By value: the list lies in memory, which the body's writes might change for all that the compiler knows.
        let (block, root, brick) = (Self::block_number(brick), self.root(), brick.start);
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
                    brick,
                    root,
                    whole: true,
                    fits,
                    mask: None,
                    next: None,
                    owner: PhantomData,
                });
            },
        );
    }

    /// Visits some rows of a block whose elements have a bit each.
    #[inline(always)]
    fn masked_rows(
        &self,
        list: &ActiveList,
        n: usize,
        rows: Range<usize>,
        fits: bool,
        run: &mut impl FnMut(Run<'_, Self>),
    ) {
        let len = <Self as Space>::RUN;
        let all = u64::MAX >> (64 - len);
        let (brick, bits) = (&list.bricks[n], list.bits(n));
        let (block, root, inside) = (Self::block_number(brick), self.root(), self.is_inside(brick));
        let brick = brick.start;
        let ahead = list.bricks.get(n + 1);
        let next = ahead.map(Self::block_number);
        let ahead = ahead.map_or(brick, |ahead| ahead.start);
        for r in rows {
            // A line or two of the block behind for each row of this one, so that all of it is there in time.
            for line in 0..Self::LINES {
                prefetch(ahead.wrapping_add((r * Self::LINES + line) * LINE));
            }
            let (word, by) = (r * len / 64, r * len % 64);
            let mut mask = bits[word] >> by;
            if 64 % len != 0 && by + len > 64 {
                mask |= bits[word + 1] << (64 - by);
            }
            mask &= all;
            if mask == 0 {
                continue;
            }
            let inner = <Self as Chained<X>>::row_place(r);
            if !inside {
                let (first, end) = self.cut(block, inner);
                mask &= if first < end { (u64::MAX >> (64 - (end - first))) << first } else { 0 };
                if mask == 0 {
                    continue;
                }
            }
            let (at, mask) = (self.start(block, inner), Some(Mask(mask)));
            run(Run {
                at,
                first: 0,
                len,
                block,
                inner,
                brick,
                root,
                whole: false,
                fits,
                mask,
                next,
                owner: PhantomData,
            });
        }
    }

    /// Visits the active elements of some rows of a block.
    #[inline(always)]
    fn rows_of<const LIGHT: bool>(
        &self,
        list: &ActiveList,
        n: usize,
        rows: Range<usize>,
        fits: bool,
        run: &mut impl FnMut(Run<'_, Self>),
    ) {
        let length = <Self as Space>::RUN;
        let (brick, bits) = (&list.bricks[n], if const { Self::GRAIN > 0 } { list.bits(n) } else { &[] });
        let (block, root, inside) = (Self::block_number(brick), self.root(), self.is_inside(brick));
        for r in rows {
            // The row's elements have one bit each, or one for them all.
            let first_bit = if const { Self::GRAIN == 1 } { r * length } else { r * length / Self::GRAIN.max(1) };
            let row_bits = if const { Self::GRAIN == 1 } { length } else { 1 };
            let set = if const { Self::GRAIN > 0 } {
                next_bit(bits, first_bit, first_bit + row_bits, true)
            } else {
                first_bit
            };
            if set == first_bit + row_bits {
                continue;
            }
            let inner = <Self as Chained<X>>::row_place(r);
            let (first, end) = if inside { (0, length) } else { self.cut(block, inner) };
            let at = self.start(block, inner);
            // One place that runs the body, for pieces of bits and for whole rows: a second one would be a second copy.
            let mut k = if const { Self::GRAIN == 1 } { set - first_bit } else { first };
            while k < end {
                let stop = match Self::GRAIN {
                    1 => next_bit(bits, first_bit + k, first_bit + length, false) - first_bit,
                    _ => end,
                };
                let (first, stop_here) = (k.max(first), stop.min(end));
                if first < stop_here {
                    let (brick, len) = (brick.start, stop_here - first);
                    let whole = LIGHT && len == length;
                    run(Run {
                        at,
                        first,
                        len,
                        block,
                        inner,
                        brick,
                        root,
                        whole,
                        fits,
                        mask: None,
                        next: None,
                        owner: PhantomData,
                    });
                }
                k = match Self::GRAIN {
                    1 => next_bit(bits, first_bit + stop, first_bit + length, true) - first_bit,
                    _ => end,
                };
            }
        }
    }

    /// The part of a row that lies in the loop's box.
    fn cut(&self, block: PerAxis, inner: PerAxis) -> (usize, usize) {
        let (axis, length) = (<Self as Space>::AXIS, <Self as Space>::RUN as i64);
        let place = Self::place(block, inner);
        let inside = (0..X::RANK)
            .all(|a| a == axis || (place[a] >= i64::from(self.first[a]) && place[a] < i64::from(self.end[a])));
        let first = (i64::from(self.first[axis]) - place[axis]).clamp(0, length);
        let end = (i64::from(self.end[axis]) - place[axis]).clamp(first, length);
        if inside { (first as usize, end as usize) } else { (0, 0) }
    }

    /// Visits some entries of a list's block.
    #[inline(always)]
    fn entries(&self, brick: &ActiveBrick, part: Range<usize>, fits: bool, run: &mut impl FnMut(Run<'_, Self>)) {
        let (block, inner, root) = (Self::block_number(brick), [0; MAX_AXES], self.root());
        let (first, end) = if self.is_inside(brick) { (0, <Self as Space>::RUN) } else { self.cut(block, inner) };
        let (first, end) = (first.max(part.start), end.min(part.end));
        if first < end {
            let (at, len, brick) = (self.start(block, inner), end - first, brick.start);
            run(Run {
                at,
                first,
                len,
                block,
                inner,
                brick,
                root,
                whole: false,
                fits,
                mask: None,
                next: None,
                owner: PhantomData,
            });
        }
    }
}
