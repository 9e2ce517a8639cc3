//! A branch of a layout over a geometry as data, for whoever asks where things lie and not for values.

use super::node::{Chain, nth_cell, order};
use super::place::Streams;
use super::{Geometry, Layout, Map};
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::record::Record;

/// Where a branch puts the members that stand in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) chain: &'static Chain,
    pub(crate) streams: &'static Streams,
    /// The root's axes in memory order, and how many there are.
    axes: ([usize; MAX_AXES], usize),
    /// The root's cells along each axis.
    blocks: PerAxis,
    /// The root's cells in all; of a sparse branch, those of one block.
    pub(crate) roots: usize,
    /// Where the branch begins in the field's memory; 0 where each block has its own.
    pub(crate) start: usize,
    /// Bytes of an innermost node, and what runs in it begin at a multiple of. A root that is the innermost node has all bytes.
    pub(crate) node_bytes: usize,
    pub(crate) align: usize,
    /// Cells of an innermost node.
    pub(crate) node_cells: usize,
    /// Of a sparse branch, the bytes of a block with its activity bits, and where these begin.
    pub(crate) brick: (usize, usize),
    nth: fn(usize) -> PerAxis,
}

impl Plan {
    /// Where a cell stands: the cells of the root's cell that it lies in are numbered from `cell - cell % chain.cells` on.
    pub(crate) fn place(&self, cell: usize) -> [u64; MAX_AXES] {
        let (mut root, inner) = (cell / self.chain.cells, (self.nth)(cell % self.chain.cells));
        let mut at = inner.map(|c| c as u64);
        for &axis in self.axes.0[..self.axes.1].iter().rev() {
            at[axis] += (root % self.blocks[axis] * self.chain.extent[axis]) as u64;
            root /= self.blocks[axis];
        }
        at
    }

    /// Innermost nodes in one piece of memory.
    pub(crate) fn nodes(&self) -> usize {
        (self.roots * self.chain.cells).checked_div(self.node_cells).unwrap_or(0)
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Map<R, L, X> {
    /// The plans of all branches, in order. `start` is where the first begins.
    pub(crate) fn plans(geometry: &Geometry, start: usize, plans: &mut Vec<Plan>) {
        let sparse = L::CHAIN.is_sparse();
        let roots = if sparse { 1 } else { geometry.cells };
        let node_cells = if Self::FLAT { roots } else { L::CHAIN.leaf };
        let align = if Self::FLAT { Self::RUN_LINE } else { Self::STREAMS.align };
        plans.push(Plan {
            chain: Self::CHAIN,
            streams: Self::STREAMS,
            axes: const { order::<X>(L::CHAIN.root) },
            blocks: geometry.blocks,
            roots,
            start: if sparse { 0 } else { start },
            node_bytes: if Self::FLAT { Self::STREAMS.bytes(node_cells, align) } else { Self::LEAF_BYTES },
            align,
            node_cells,
            brick: if sparse { (Self::SIZES.brick, Self::SIZES.bits_at) } else { (0, 0) },
            nth: |cell| nth_cell::<X>(L::CHAIN.digits, L::CHAIN.extent, L::CHAIN.cells, cell),
        });
        if L::BRANCHES > 1 {
            Map::<R, L::Rest, X>::plans(&geometry.rest::<L, X>(), start + Self::rest_start(geometry), plans);
        }
    }
}
