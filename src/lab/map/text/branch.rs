//! A chain of nodes over a shape: where in its memory, or in one of its blocks, each cell lies.

use super::layout::{Chain, List, NodeKind};
use super::levels::{Level, Levels, Place};
use super::streams::Stream;
use crate::lab::map::Member;

/// What every piece of memory begins at a multiple of.
const LINE: usize = 64;
/// Cells along the last axis of an outermost `bitmasked` without a size.
const BITS: usize = 64;

/// One branch.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// The blocks in a cell of the root; of a sparse branch, those that are allocated together.
    pub(super) levels: Levels,
    /// The root's axes in order.
    pub(super) root: Vec<usize>,
    pub(super) streams: Vec<Stream>,
    /// Of a sparse branch, what stands above its blocks.
    pub(super) sparse: Option<Sparse>,
    /// What runs begin at a multiple of in a node of constant size.
    align: usize,
    /// The same of what is one run a stream, and of blocks.
    line: usize,
    /// Whether the root is the innermost node.
    flat: bool,
}

/// What stands above the blocks of a sparse branch.
#[derive(Clone, Debug)]
pub(super) struct Sparse {
    /// The nodes between root and blocks.
    pub(super) upper: Levels,
    /// Whether the root has no bounds.
    pub(super) hash: bool,
    /// Whether blocks are the root's own, there from the start, rather than pointed to.
    pub(super) own: bool,
    pub(super) list: Option<List>,
    /// Cells that share an activity bit; 0 where a block is active as a whole.
    pub(super) grain: usize,
}

impl Branch {
    pub(super) fn new(chain: &Chain, streams: Vec<Stream>, members: &[Member]) -> Self {
        let pad = chain.pad.unwrap_or(1);
        let widest = members.iter().map(|member| member.scalar_bytes).max().unwrap_or(1);
        let root = chain.nodes.first().map(|node| node.axes.clone()).unwrap_or_default();
        let (upper, levels, grain) = cut(chain);
        let flat = levels.0.is_empty();
        let hash = chain.nodes.first().is_some_and(|node| node.kind == NodeKind::Hash);
        let own = chain.list.is_none() && !chain.nodes.iter().any(|node| node.kind.points());
        let sparse = chain.is_sparse().then_some(Sparse { upper, hash, own, list: chain.list, grain });
        Self { levels, root, streams, sparse, align: widest.max(pad), line: LINE.max(pad), flat }
    }

    /// What the branch's memory begins at a multiple of.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// Elements along each axis of a cell of the root.
    pub(super) fn root_extent(&self) -> Place {
        let (inner, upper) = (self.levels.extent(), self.sparse.as_ref().map(|sparse| sparse.upper.extent()));
        let mut extent = std::array::from_fn(|axis| inner[axis] * upper.map_or(1, |upper| upper[axis]));
        if let Some(list) = self.sparse.as_ref().and_then(|sparse| sparse.list) {
            extent[list.axis] = list.most as i64;
        }
        extent
    }

    /// The root as a block of cells over a shape; `None` where there are more than can be counted.
    pub(super) fn root_over(&self, shape: &[usize]) -> Option<Level> {
        let extent = self.root_extent();
        let sizes: Vec<usize> = self.root.iter().map(|&axis| shape[axis].div_ceil(extent[axis] as usize)).collect();
        sizes.iter().try_fold(1usize, |cells, &size| cells.checked_mul(size))?;
        Some(Level::new(&self.root, &sizes, false))
    }

    /// Cells of an innermost node where there are so many in all.
    pub(super) fn node_cells(&self, cells: usize) -> usize {
        self.levels.0.last().map_or(cells, Level::cells)
    }

    /// Bytes of so many cells; `None` where they overflow.
    pub(super) fn bytes(&self, cells: usize) -> Option<usize> {
        let (node, align) = (self.node_cells(cells), self.align());
        let run = |stream: &Stream| node.checked_mul(stream.item)?.checked_next_multiple_of(align);
        let node_bytes = self.streams.iter().try_fold(0usize, |bytes, stream| bytes.checked_add(run(stream)?))?;
        cells.checked_div(node).unwrap_or(0).checked_mul(node_bytes)
    }

    /// What runs begin at a multiple of.
    fn align(&self) -> usize {
        if self.flat { self.line } else { self.align }
    }

    /// Where the activity bits of a block begin, how many there are, and the block's bytes.
    pub(super) fn block(&self) -> Option<(usize, usize, usize)> {
        let grain = self.sparse.as_ref().map_or(0, |sparse| sparse.grain);
        let bits = self.levels.cells().checked_div(grain).unwrap_or(0);
        let at = self.bytes(self.levels.cells())?.checked_next_multiple_of(8)?;
        let bytes = at.checked_add(bits.div_ceil(64) * 8)?.checked_next_multiple_of(self.line)?;
        Some((at, bits, bytes))
    }

    /// The runs of an innermost node: the stream, and where in the node it begins.
    pub(super) fn runs(&self, cells: usize) -> impl Iterator<Item = (&Stream, usize)> {
        let (node, align) = (self.node_cells(cells), self.align());
        self.streams.iter().scan(0, move |at, stream| {
            let start = *at;
            *at += (node * stream.item).next_multiple_of(align);
            Some((stream, start))
        })
    }
}

/// The nodes above the blocks that are allocated together, those in them, and how many cells share an activity bit.
fn cut(chain: &Chain) -> (Levels, Levels, usize) {
    let nodes = &chain.nodes;
    // A size of the outermost node groups cells: the root above it takes as many as the shape needs.
    let level = |number: usize| {
        let node = &nodes[number];
        let row = |axes: &[usize]| (1..axes.len()).map(|_| 1).chain([BITS]).collect::<Vec<_>>();
        match (node.kind, &node.sizes) {
            (NodeKind::Bitmasked, None) => Some(Level::new(&node.axes, &row(&node.axes), false)),
            _ => Level::of(node),
        }
    };
    let levels = |numbers: std::ops::Range<usize>| Levels(numbers.filter_map(level).collect());
    if let Some(list) = chain.list {
        return (levels(0..nodes.len()), Levels(vec![Level::new(&[list.axis], &[list.chunk], false)]), 0);
    }
    let first = nodes.iter().rposition(|node| node.kind.points()).map_or(0, |last| last + 1);
    let mut inner = levels(first..nodes.len());
    let masked = (first..nodes.len()).rev().find(|&number| nodes[number].kind == NodeKind::Bitmasked);
    let grain = masked.map_or(0, |masked| levels(masked + 1..nodes.len()).cells());
    if inner.0.is_empty() && first > 0 {
        // One record a pointer.
        let axes = &nodes[nodes.len() - 1].axes;
        inner.0.push(Level::new(axes, &vec![1; axes.len()], false));
    }
    (levels(0..first), inner, grain)
}
