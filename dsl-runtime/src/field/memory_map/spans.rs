//! The bytes of elements, in the order in which they lie.

use core::ops::Range;

use super::{Allocation, Branch, MemoryMap};
use crate::axes::MAX_AXES;
use crate::layout::place::Stream;

/// Bytes that hold a member of an element, or one of its components where they lie apart.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Span {
    /// What of [`MemoryMap::allocations`] they are a part of.
    pub allocation: usize,
    /// Where in it.
    pub bytes: Range<usize>,
    /// The number of the member.
    pub member: usize,
    /// The components that lie here, one after another.
    pub components: Range<usize>,
    /// The number of the root's cell that the element is in: a block of all constant nodes.
    pub block: usize,
    /// The number of the innermost node that it is in.
    pub node: usize,
    /// Whether there is such an element, and it is active.
    pub standing: Standing,
    at: [i32; MAX_AXES],
    rank: usize,
}

impl Span {
    /// The element's index, a number an axis. That of a cell beyond the shape is what it would be.
    pub fn index(&self) -> &[i32] {
        &self.at[..self.rank]
    }
}

/// What a cell is that has room in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Standing {
    /// An active element, as all of dense layouts are.
    Active,
    /// An element that reads as the background.
    Inactive,
    /// A cell of a partial block, beyond the shape.
    Beyond,
}

/// One stream of an innermost node: items of equal size, one a cell.
#[derive(Clone, Copy)]
struct Run {
    /// Where it begins in its allocation.
    start: usize,
    stream: usize,
    item: usize,
    /// Which component it holds, where the member's lie apart.
    component: Option<usize>,
    node: usize,
}

impl MemoryMap<'_> {
    /// The bytes of all elements, allocation by allocation in the order in which they lie, with those of cells beyond the shape.
    pub fn spans(&self) -> impl Iterator<Item = Span> + '_ {
        (0..self.allocations().len()).flat_map(|n| self.spans_in(n, 0..usize::MAX))
    }

    /// Those of one allocation of which a byte lies in a range: found at once, however large the field.
    ///
    /// # Panics
    /// Where there are not so many allocations.
    pub fn spans_in(&self, allocation: usize, bytes: Range<usize>) -> impl Iterator<Item = Span> + '_ {
        let within = &self.allocations[allocation];
        let bytes = bytes.start..bytes.end.min(within.bytes);
        let touched = bytes.clone();
        let runs = self.branches_of(within).flat_map(move |branch| {
            let runs = branch.nodes_in(&bytes).flat_map(move |node| branch.runs(node));
            let bytes = bytes.clone();
            runs.flat_map(move |run| branch.items(run, &bytes).map(move |cell| (branch, run, cell)))
        });
        let spans = runs.flat_map(move |(branch, run, cell)| {
            let members = branch.seats[run.stream].iter();
            members.map(move |&seat| self.span(allocation, branch, run, cell, seat))
        });
        // Of an item that begins or ends in the range, not every member does; members without components have no bytes.
        spans.filter(move |span| span.bytes.start.max(touched.start) < span.bytes.end.min(touched.end))
    }

    /// Where in an allocation the values of a member, or of a component that lies apart, first begin, in order.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let field = Field::<Vec2, Split>::new([100]);
    /// assert_eq!(field.memory_map().starts(0), [0, 448]);
    /// ```
    ///
    /// # Panics
    /// Where there are not so many allocations.
    pub fn starts(&self, allocation: usize) -> Vec<usize> {
        let branches = self.branches_of(&self.allocations[allocation]);
        let runs = branches.filter(|branch| branch.plan.nodes() > 0).flat_map(|branch| branch.runs(0));
        runs.filter(|run| run.item > 0).map(|run| run.start).collect()
    }

    /// The branches that an allocation holds elements of.
    fn branches_of<'b>(&'b self, allocation: &'b Allocation) -> impl Iterator<Item = &'b Branch> + 'b {
        let dense = allocation.block.is_none();
        self.branches.iter().enumerate().filter_map(move |(n, branch)| {
            let here = if dense { !branch.plan.chain.is_sparse() } else { n == allocation.branch };
            here.then_some(branch)
        })
    }

    fn span(&self, allocation: usize, branch: &Branch, run: Run, cell: usize, seat: (usize, usize)) -> Span {
        let (member, offset) = seat;
        let (within, facts) = (&self.allocations[allocation], &self.members[member]);
        let start = run.start + cell * run.item + offset;
        let components = run.component.map_or(0..facts.components, |component| component..component + 1);
        let number = run.node * branch.plan.node_cells + cell;
        let mut place = branch.plan.place(number);
        if within.block.is_some() {
            place = core::array::from_fn(|a| within.first[a] + place[a]);
        }
        Span {
            allocation,
            bytes: start..start + components.len() * facts.scalar_bytes,
            member,
            components,
            block: number / branch.plan.chain.cells,
            node: run.node,
            standing: self.standing(within, branch, number, &place),
            at: self.geometry.logical(place.map(|c| c as u32)),
            rank: self.shape.len(),
        }
    }

    fn standing(&self, within: &Allocation, branch: &Branch, cell: usize, place: &[u64; MAX_AXES]) -> Standing {
        let beyond = |a: usize| place[a] >= u64::from(self.geometry.shape[a]);
        if (0..self.shape.len()).any(beyond) {
            return Standing::Beyond;
        }
        let grain = branch.plan.chain.tree.map_or(0, |tree| tree.grain);
        let active = match cell.checked_div(grain) {
            Some(bit) => within.bits[bit / 64] >> (bit % 64) & 1 == 1,
            None => cell < within.entries,
        };
        if active { Standing::Active } else { Standing::Inactive }
    }
}

impl Branch {
    /// The innermost nodes that have bytes in a range of the memory that they lie in.
    fn nodes_in(&self, bytes: &Range<usize>) -> Range<usize> {
        let plan = &self.plan;
        let from = bytes.start.saturating_sub(plan.start).checked_div(plan.node_bytes);
        let to = bytes.end.saturating_sub(plan.start).div_ceil(plan.node_bytes.max(1)).min(plan.nodes());
        from.map_or(0..0, |from| from..to.max(from))
    }

    /// The cells of a run that have bytes in a range.
    fn items(&self, run: Run, bytes: &Range<usize>) -> Range<usize> {
        let from = bytes.start.saturating_sub(run.start).checked_div(run.item);
        let to = bytes.end.saturating_sub(run.start).div_ceil(run.item.max(1)).min(self.plan.node_cells);
        from.map_or(0..0, |from| from..to.max(from))
    }

    /// The runs of an innermost node.
    fn runs(&self, node: usize) -> impl Iterator<Item = Run> + '_ {
        let (plan, streams) = (&self.plan, self.plan.streams);
        let node_start = plan.start + node * plan.node_bytes;
        streams.streams[..streams.count].iter().enumerate().flat_map(move |(stream, &Stream { item, repeats })| {
            let split = self.seats[stream].iter().any(|&(member, _)| streams.seats[member].split);
            let first = node_start + streams.start(stream, plan.node_cells, plan.align);
            let bytes = (plan.node_cells * item).next_multiple_of(plan.align);
            (0..repeats).map(move |repeat| Run {
                start: first + repeat * bytes,
                stream,
                item,
                component: split.then_some(repeat),
                node,
            })
        })
    }
}
