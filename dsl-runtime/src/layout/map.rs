//! The address of a component: geometry is types, the record's facts are constants, both meet here.

use core::marker::PhantomData;

use super::node::{Chain, order};
use super::place::{Seat, Streams, round_up};
use super::{Geometry, Inner, Layout};
use crate::axes::{Axes, MAX_AXES, PerAxis, sum};
use crate::field::memory::LINE;
use crate::record::{ElementList, MAX_MEMBERS, Names, Record};

/// Where the records `R` lie in the layout `L` over `X`. Members that stand in no node of the first branch are asked for in the
/// others: which one it is, is known at compile time.
pub(crate) struct Map<R, L, X>(PhantomData<(R, L, X)>);

/// What is to be known of one member of one branch.
#[derive(Clone, Copy)]
struct Facts {
    seat: Seat,
    /// Where it begins in the innermost node (constant trees).
    start: usize,
    stride: usize,
    /// Bytes between its components (constant trees).
    component: usize,
    /// Whether it stands in the first branch.
    here: bool,
}

impl<R: Record, L: Layout<X>, X: Axes> Map<R, L, X> {
    // Tables stand behind references: a use then reads one entry, and copies nothing.
    pub(super) const STREAMS: &'static Streams =
        &Streams::of(L::CHAIN.spec, L::CHAIN.pad, R::Elements::MEMBERS, Names::<R>::ALL);
    pub(super) const CHAIN: &'static Chain = &L::CHAIN;
    /// What each run of a flat root begins at a multiple of: a cache line, or what the layout asks for.
    pub(super) const RUN_LINE: usize = if L::CHAIN.pad > LINE { L::CHAIN.pad } else { LINE };
    /// What the field's memory and each branch begin at a multiple of.
    pub(crate) const LINE: usize = Self::line();
    pub(super) const FLAT: bool = L::CHAIN.is_flat();
    /// Bytes of the innermost node (constant trees).
    pub(super) const LEAF_BYTES: usize =
        round_up(Self::STREAMS.bytes(L::CHAIN.leaf, Self::STREAMS.align), Self::STREAMS.align);
    /// Bytes of one of the root's cells (constant trees).
    pub(super) const BLOCK_BYTES: usize =
        if Self::FLAT { 0 } else { L::CHAIN.cells / L::CHAIN.leaf * Self::LEAF_BYTES };
    const FACTS: &'static [Facts; MAX_MEMBERS] = &{
        let nowhere = Streams::NOWHERE;
        let mut facts = [Facts { seat: nowhere, start: 0, stride: 0, component: 0, here: false }; MAX_MEMBERS];
        let (mut m, streams) = (0, Self::STREAMS);
        while m < R::Elements::MEMBERS.len() {
            if streams.holds(m) {
                let seat = streams.seats[m];
                facts[m] = Facts {
                    seat,
                    start: streams.start(seat.stream, L::CHAIN.leaf, streams.align) + seat.offset,
                    stride: streams.stride(m),
                    component: streams.component(m, L::CHAIN.leaf, streams.align),
                    here: true,
                };
            }
            m += 1;
        }
        facts
    };
    /// Every member stands in one branch: one that stands in two, or in none, is an error when a field is made.
    const COMPLETE: () = {
        let mut m = 0;
        while m < R::Elements::MEMBERS.len() {
            let branches = Self::branches_with(m);
            assert!(branches != 0, "the layout leaves a member of the record out of all its branches");
            assert!(branches == 1, "the layout places a member of the record in two branches");
            m += 1;
        }
    };

    // A function: a constant of its own rest would be evaluated though there is none.
    const fn line() -> usize {
        let rest = if L::BRANCHES > 1 { Map::<R, L::Rest, X>::line() } else { LINE };
        if Self::RUN_LINE > rest { Self::RUN_LINE } else { rest }
    }

    /// How many branches hold a member.
    const fn branches_with(m: usize) -> usize {
        let rest = if L::BRANCHES > 1 { Map::<R, L::Rest, X>::branches_with(m) } else { 0 };
        Self::FACTS[m].here as usize + rest
    }

    /// Whether a member stands in the first branch. Whoever asks for the others if not asks for their number first, in a block of its own: the compiler then
    /// sees no recursion where there is one branch.
    #[inline(always)]
    pub(super) const fn here(m: usize) -> bool {
        L::BRANCHES == 1 || Self::FACTS[m].here
    }

    /// Where a member stands. A call would hide from loops that it is a constant: clearing whole records took three times as long.
    #[inline(always)]
    const fn facts(m: usize) -> &'static Facts {
        if const { L::BRANCHES == 1 } || Self::here(m) { &Self::FACTS[m] } else { Map::<R, L::Rest, X>::facts(m) }
    }

    /// The branch that a member stands in.
    #[inline(always)]
    pub(crate) const fn chain(m: usize) -> &'static Chain {
        if const { L::BRANCHES == 1 } || Self::here(m) { Self::CHAIN } else { Map::<R, L::Rest, X>::chain(m) }
    }

    /// The number of a member's branch.
    #[inline(always)]
    pub(crate) const fn branch(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) { 0 } else { 1 + Map::<R, L::Rest, X>::branch(m) }
    }

    /// Whether so many members from one on stand in one branch.
    pub(crate) const fn is_one_branch(first: usize, count: usize) -> bool {
        let mut m = first;
        while m < first + count {
            if Self::branch(m) != Self::branch(first) {
                return false;
            }
            m += 1;
        }
        true
    }

    /// The geometry of a member's branch.
    #[inline(always)]
    pub(crate) fn geometry(geometry: &Geometry, m: usize) -> Geometry {
        if const { L::BRANCHES == 1 } || Self::here(m) {
            *geometry
        } else {
            Map::<R, L::Rest, X>::geometry(&geometry.rest::<L, X>(), m)
        }
    }

    /// The root's fastest axis, whose stride is 1 by construction: a constant.
    pub(super) const FASTEST: usize = {
        let (axes, count) = order::<X>(L::CHAIN.root);
        if count == 0 { 0 } else { axes[count - 1] }
    };

    /// That of a member's branch.
    #[inline(always)]
    pub(crate) const fn fastest(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) { Self::FASTEST } else { Map::<R, L::Rest, X>::fastest(m) }
    }

    /// Bytes between the values of member `m` of neighbours within a block along each axis; 0 where they lie at various distances (constant trees).
    pub(crate) const fn steps(m: usize) -> PerAxis {
        let (digits, cells, leaf) = (Self::chain(m).digits, Self::chain(m).cells, Self::chain(m).leaf);
        let (mut steps, mut levels, mut rest) = ([0; MAX_AXES], [0; MAX_AXES], cells);
        let mut d = 0;
        while d < digits.len() && digits[d].order != 0 && leaf > 0 {
            let (axes, count) = order::<X>(digits[d].order);
            let mut n = 0;
            while n < count {
                let size = digits[d].sizes[axes[n]];
                rest /= size;
                if size > 1 {
                    // Of an innermost node neighbours lie at the member's stride, of others as many bytes apart as the nodes between take.
                    steps[axes[n]] =
                        if rest < leaf { rest * Self::stride(m) } else { rest / leaf * Self::leaf_bytes(m) };
                    levels[axes[n]] += if digits[d].curve { 2 } else { 1 };
                }
                n += 1;
            }
            d += 1;
        }
        let mut axis = 0;
        while axis < MAX_AXES {
            if levels[axis] != 1 {
                steps[axis] = 0;
            }
            axis += 1;
        }
        steps
    }

    /// The root's cells between neighbours along an axis, in a member's branch.
    #[inline(always)]
    pub(crate) fn root_stride(geometry: &Geometry, m: usize, axis: usize) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::root_stride(&geometry.rest::<L, X>(), m, axis);
        }
        if axis == Self::FASTEST { 1 } else { geometry.stride[axis] }
    }

    /// Bytes of one of the root's cells in a member's branch (constant trees).
    #[inline(always)]
    pub(crate) const fn block_bytes(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) {
            Self::BLOCK_BYTES
        } else {
            Map::<R, L::Rest, X>::block_bytes(m)
        }
    }

    /// Bytes of an innermost node of a member's branch (constant trees).
    #[inline(always)]
    pub(crate) const fn leaf_bytes(m: usize) -> usize {
        if const { L::BRANCHES == 1 } || Self::here(m) { Self::LEAF_BYTES } else { Map::<R, L::Rest, X>::leaf_bytes(m) }
    }

    /// Where a member stands in its stream.
    #[inline(always)]
    pub(crate) const fn seat(m: usize) -> Seat {
        Self::facts(m).seat
    }

    /// Whether every component of a member lies at a multiple of its size.
    #[inline(always)]
    pub(crate) const fn aligned(m: usize) -> bool {
        if const { L::BRANCHES == 1 } || Self::here(m) {
            Self::STREAMS.aligned(m)
        } else {
            Map::<R, L::Rest, X>::aligned(m)
        }
    }

    /// Bytes of the first branch; `None` where they overflow.
    fn branch_bytes(geometry: &Geometry) -> Option<usize> {
        let cells = geometry.cells as u128;
        let bytes = if const { L::CHAIN.is_sparse() } {
            // The address of what holds the blocks.
            Self::LINE as u128
        } else if const { Self::FLAT } {
            let streams = Self::STREAMS;
            let run = |item: usize| (cells * item as u128).next_multiple_of(Self::RUN_LINE as u128);
            streams.streams[..streams.count].iter().map(|s| s.repeats as u128 * run(s.item)).sum()
        } else {
            cells * Self::BLOCK_BYTES as u128
        };
        usize::try_from(bytes).ok().filter(|&bytes| isize::try_from(bytes).is_ok())
    }

    /// Where the branches behind the first begin.
    #[inline(always)]
    pub(super) fn rest_start(geometry: &Geometry) -> usize {
        let bytes = if const { L::CHAIN.is_sparse() } {
            Self::LINE
        } else if const { Self::FLAT } {
            Self::flat_start(geometry.cells, Self::STREAMS.count)
        } else {
            geometry.cells.wrapping_mul(Self::BLOCK_BYTES)
        };
        bytes.next_multiple_of(Self::LINE)
    }

    /// All bytes of a field; `None` where they overflow.
    pub(crate) fn bytes(geometry: &Geometry) -> Option<usize> {
        let bytes = Self::branch_bytes(geometry)?;
        if const { L::BRANCHES == 1 } {
            return Some(bytes);
        }
        let rest = Map::<R, L::Rest, X>::bytes(&geometry.rest::<L, X>())?;
        let all = bytes.checked_next_multiple_of(Self::LINE)?.checked_add(rest)?;
        isize::try_from(all).is_ok().then_some(all)
    }

    /// Fails to compile where a member stands in no branch, or in two.
    pub(crate) fn complete() {
        const { Self::COMPLETE }
    }

    /// Whether all of a field is one run of records without anything between them.
    pub(crate) const fn is_one_run() -> bool {
        // A run for each component ends with what is left of a line.
        let one = Self::STREAMS.count == 1 && Self::STREAMS.streams[0].repeats == 1;
        L::BRANCHES == 1 && !L::CHAIN.is_sparse() && Self::FLAT && one
    }

    /// Bytes of one record of such a field.
    pub(crate) const fn run_item() -> usize {
        Self::STREAMS.streams[0].item
    }

    /// Bytes between the values of member `m` of neighbouring cells of the innermost node.
    #[inline(always)]
    pub(crate) const fn stride(m: usize) -> usize {
        Self::facts(m).stride
    }

    /// Where member `m` of a flat root, or of each innermost node, begins: in a sparse branch, within its block.
    #[inline(always)]
    pub(crate) fn start(geometry: &Geometry, m: usize) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            let rest = Map::<R, L::Rest, X>::start(&geometry.rest::<L, X>(), m);
            let before = if Self::chain(m).is_sparse() { 0 } else { Self::rest_start(geometry) };
            return before.wrapping_add(rest);
        }
        if const { Self::FLAT } {
            let seat = Self::FACTS[m].seat;
            if Self::STREAMS.count == 1 {
                return seat.offset;
            }
            Self::flat_start(geometry.cells, seat.stream) + seat.offset
        } else {
            Self::FACTS[m].start
        }
    }

    #[inline(always)]
    fn flat_start(cells: usize, stream: usize) -> usize {
        let streams = Self::STREAMS;
        let mut bytes = 0;
        // Written as a loop over a constant list: it unrolls, and is hoisted out of every loop over cells.
        for s in &streams.streams[..stream] {
            bytes += s.repeats * round_up(cells * s.item, Self::RUN_LINE);
        }
        bytes
    }

    /// Bytes between the components of member `m`.
    #[inline(always)]
    pub(crate) fn component(geometry: &Geometry, m: usize) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::component(&geometry.rest::<L, X>(), m);
        }
        if const { Self::FLAT } {
            let seat = Self::FACTS[m].seat;
            if seat.split { round_up(geometry.cells * Self::FACTS[m].stride, Self::RUN_LINE) } else { seat.scalar }
        } else {
            Self::FACTS[m].component
        }
    }

    /// Bytes between the components of member `m` where they are a constant; else 0.
    #[inline(always)]
    pub(crate) const fn constant_component(m: usize) -> usize {
        let (facts, flat) = (Self::facts(m), Self::chain(m).is_flat());
        if !facts.seat.split {
            facts.seat.scalar
        } else if flat {
            0
        } else {
            facts.component
        }
    }

    /// The offset of member `m` of the element at `at`, which lies within the shape.
    #[inline(always)]
    pub(crate) fn offset(geometry: &Geometry, m: usize, at: [u32; MAX_AXES]) -> usize {
        let start = Self::start(geometry, m);
        start.wrapping_add(sum::<X>(
            #[inline(always)]
            |a| Self::term(geometry, m, a, at[a]),
        ))
    }

    /// What coordinate `c` along `axis` adds to the offset of member `m`.
    #[inline(always)]
    pub(crate) fn term(geometry: &Geometry, m: usize, axis: usize, c: u32) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::term(&geometry.rest::<L, X>(), m, axis, c);
        }
        if const { Self::FLAT } {
            (c as usize).wrapping_mul(Self::root_stride(geometry, m, axis)).wrapping_mul(Self::stride(m))
        } else {
            let extent = Self::CHAIN.extent[axis] as u32;
            let (block, inner) = (c / extent, c % extent);
            (block as usize)
                .wrapping_mul(Self::root_stride(geometry, m, axis))
                .wrapping_mul(Self::BLOCK_BYTES)
                .wrapping_add(Self::inner(m, axis, inner as usize))
        }
    }

    /// What coordinate `c` within a block along `axis` adds to the offset of member `m` (constant trees).
    #[inline(always)]
    pub(crate) fn inner(m: usize, axis: usize, c: usize) -> usize {
        if const { L::BRANCHES > 1 } && !Self::here(m) {
            return Map::<R, L::Rest, X>::inner(m, axis, c);
        }
        <L::Inner as Inner<X>>::term(axis, c, Self::LEAF_BYTES, Self::stride(m))
    }
}
