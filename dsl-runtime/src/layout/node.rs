//! What all structural nodes share: the chain below the root.

use crate::axes::{Axes, MAX_AXES, PerAxis, per_axis};
use crate::element::Sealed;
use crate::layout::levels::ListSpec;
use crate::layout::{Place, Spec};

/// One level of one axis: how many cells, and how far apart they are in the node's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub struct Digit {
    /// The order of the node's axes.
    pub order: u32,
    /// Its sizes.
    pub sizes: PerAxis,
    /// Whether its cells lie in Z-order rather than in that of the axes.
    pub curve: bool,
}

/// The most nodes of constant size in a layout.
pub(crate) const MOST_NODES: usize = 6;

/// The list of a node and of those below it. An entry of order 0 ends a list that is not full.
pub(crate) const fn chain(digit: Digit, below: &[Digit]) -> [Digit; MOST_NODES] {
    let mut digits = [Digit { order: 0, sizes: [0; MAX_AXES], curve: false }; MOST_NODES];
    digits[0] = digit;
    let mut n = 0;
    while n < below.len() && below[n].order != 0 {
        // The order of memory is read off the list, so that a list which is cut off would repeat cells.
        assert!(n + 1 < MOST_NODES, "a layout has at most six nodes of constant size");
        digits[n + 1] = below[n];
        n += 1;
    }
    digits
}

/// The sizes along the axes that a node names; 1 along the others.
pub(crate) const fn sizes<X: Axes>(code: u32, given: PerAxis) -> PerAxis {
    let (axes, count) = order::<X>(code);
    let (mut sizes, mut n) = ([1; MAX_AXES], 0);
    // Without axes there is one cell, however many a named layout has along each.
    while n < count && X::RANK > 0 {
        sizes[axes[n]] = given[axes[n]];
        n += 1;
    }
    sizes
}

/// All cells of a block.
pub(crate) const fn product(sizes: PerAxis) -> usize {
    sizes[0] * sizes[1] * sizes[2] * sizes[3]
}

/// A chain of nodes of constant size below the root, closed by a place.
#[doc(hidden)]
pub trait Inner<X: Axes>: Copy + Send + Sync + Sealed + 'static {
    /// How the innermost node's cells hold records.
    type Place: Place;
    /// Cells along each axis.
    const EXTENT: PerAxis;
    /// Cells in all.
    const CELLS: usize;
    /// Cells of the innermost node; 0 if there is none, so that the root is the innermost.
    const LEAF: usize;
    /// Cells of the innermost node along its last axis, one after another in memory; 0 if there is none.
    const RUN: usize;
    /// That axis.
    const RUN_AXIS: usize;
    /// How many such runs there are.
    const ROWS: usize;
    /// The nodes as data, outermost first: equal lists mean equal arrangements.
    const DIGITS: &'static [Digit];
    /// Cells that share one activity bit; 0 where cells have none.
    const GRAIN: usize;
    /// Bytes that coordinate `c` along `axis` adds to a cell's address: addresses are sums of one term an axis.
    fn term(axis: usize, c: usize, leaf_bytes: usize, stride: usize) -> usize;
}

/// A root and the nodes of constant size below it, as data.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Chain {
    /// The order of the root's axes.
    pub(crate) root: u32,
    /// As in [`Inner`].
    pub(crate) extent: PerAxis,
    pub(crate) cells: usize,
    pub(crate) leaf: usize,
    pub(crate) run: usize,
    /// The axis along which neighbours lie one after another.
    pub(crate) run_axis: usize,
    pub(crate) rows: usize,
    pub(crate) digits: &'static [Digit],
    /// What the place does.
    pub(crate) spec: Spec,
    /// The bytes that cells or runs begin at a multiple of.
    pub(crate) pad: usize,
    /// What stands above the nodes of a sparse layout; nothing where all are there from the start.
    pub(crate) tree: Option<Tree>,
}

/// What stands above the blocks of a sparse layout, as data. A block is the nodes of constant size.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Tree {
    /// How the root finds its cells.
    pub(crate) root: Root,
    /// Blocks that a cell of the root spans along each axis.
    pub(crate) span: PerAxis,
    /// The lists that the blocks hold the entries of, if they do.
    pub(crate) list: Option<ListSpec>,
    /// Cells that share one activity bit; 0 where a block is active as a whole.
    pub(crate) grain: usize,
}

/// How a root finds its cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum Root {
    /// They lie in a grid.
    Grid,
    /// By hashing.
    Hash,
}

impl Chain {
    /// The chain of a root over the axes of `root` with the nodes `N`.
    pub(crate) const fn of<N: Inner<X>, X: Axes>(root: u32) -> Self {
        let (axes, count) = order::<X>(root);
        Self {
            root,
            extent: N::EXTENT,
            cells: N::CELLS,
            leaf: N::LEAF,
            run: N::RUN,
            run_axis: if N::LEAF == 0 { axes[count - 1] } else { N::RUN_AXIS },
            rows: N::ROWS,
            digits: N::DIGITS,
            spec: <N::Place as Place>::SPEC,
            pad: <N::Place as Place>::PAD,
            tree: None,
        }
    }

    /// Whether blocks are made when they are needed, or have activity bits.
    #[inline(always)]
    pub(crate) const fn is_sparse(&self) -> bool {
        self.tree.is_some()
    }

    /// The elements that a cell of the root spans along each axis.
    pub(crate) const fn root_extent(&self) -> PerAxis {
        let mut extent = self.extent;
        if let Some(tree) = &self.tree {
            let mut axis = 0;
            while axis < MAX_AXES {
                extent[axis] *= tree.span[axis];
                axis += 1;
            }
        }
        extent
    }

    /// Activity bits of a block.
    pub(crate) const fn bits(&self) -> usize {
        match &self.tree {
            Some(tree) if tree.grain > 0 => self.cells / tree.grain,
            _ => 0,
        }
    }

    /// Whether the root is the innermost node.
    #[inline(always)]
    pub(crate) const fn is_flat(&self) -> bool {
        self.leaf == 0
    }
}

/// Where run `r` of a block begins, in memory order.
#[inline(always)]
pub(crate) const fn nth_row<X: Axes>(chain: &Chain, r: usize) -> PerAxis {
    nth_cell::<X>(chain.digits, chain.extent, chain.cells, r * chain.run)
}

/// Where cell `n` of a block lies, in memory order: of the nodes' cells, all in all, which extend so far.
#[inline(always)]
pub(crate) const fn nth_cell<X: Axes>(digits: &[Digit], extent: PerAxis, cells: usize, n: usize) -> PerAxis {
    let mut at = [0; MAX_AXES];
    let (mut rest, mut unit, mut cells) = (n, extent, cells);
    let mut level = 0;
    while level < digits.len() && digits[level].order != 0 {
        let digit = digits[level];
        let (axes, count) = order::<X>(digit.order);
        let mut n = 0;
        if digit.curve {
            cells /= product(digit.sizes);
            let place = super::morton::place::<X>(digit.order, digit.sizes, rest / cells);
            rest %= cells;
            while n < count {
                unit[axes[n]] /= digit.sizes[axes[n]];
                at[axes[n]] += place[axes[n]] * unit[axes[n]];
                n += 1;
            }
        }
        while n < count {
            let size = digit.sizes[axes[n]];
            cells /= size;
            unit[axes[n]] /= size;
            at[axes[n]] += rest / cells * unit[axes[n]];
            rest %= cells;
            n += 1;
        }
        level += 1;
    }
    at
}

/// The most rows of a block whose places are in a table.
const TABLED: usize = 256;

/// A chain that is known at compile time.
pub(crate) trait Chained<X: Axes> {
    const CHAIN: &'static Chain;

    /// Where the first rows of a block begin: finding them by division, or by bits in Z-order, takes longer than many a body.
    const PLACES: &'static [[u16; MAX_AXES]; TABLED] = &{
        let (mut places, mut r) = ([[0; MAX_AXES]; TABLED], 0);
        while r < Self::CHAIN.rows && r < TABLED {
            let place = nth_row::<X>(Self::CHAIN, r);
            let mut axis = 0;
            while axis < MAX_AXES {
                places[r][axis] = place[axis] as u16;
                axis += 1;
            }
            r += 1;
        }
        places
    };
    /// Whether all rows are in that table.
    const IS_TABLED: bool = {
        let (extent, long) = (Self::CHAIN.extent, (1 << 16) - 1);
        Self::CHAIN.rows <= TABLED && extent[0] < long && extent[1] < long && extent[2] < long && extent[3] < long
    };
    /// Where a row of a block begins, looked up.
    #[inline(always)]
    fn row_place(r: usize) -> PerAxis {
        if const { Self::IS_TABLED } {
            let place = Self::PLACES[r];
            per_axis(
                #[inline(always)]
                |a| place[a] as usize,
            )
        } else {
            nth_row::<X>(Self::CHAIN, r)
        }
    }
}

/// Visits the beginnings of a block's runs in memory order. Few are written out, so that their places are constants.
#[inline(always)]
pub(crate) fn rows<T: Chained<X>, X: Axes>(mut row: impl FnMut(PerAxis)) {
    macro_rules! written_out {
        ($($r:literal)*) => {$(
            if const { T::CHAIN.rows > $r } {
                row(const { if T::CHAIN.rows > $r { nth_row::<X>(T::CHAIN, $r) } else { [0; MAX_AXES] } });
            }
        )*};
    }
    if const { T::CHAIN.rows <= 8 } {
        written_out!(0 1 2 3 4 5 6 7);
    } else {
        for r in 0..const { T::CHAIN.rows } {
            row(T::row_place(r));
        }
    }
}

/// The axes of a node in memory order, read from `ORDER`: one hexadecimal digit an axis, the first axis highest.
/// [`ALL`] stands for every axis of the field, [`LAST`] for its last one; a field without axes lies as one of one element.
pub(crate) const fn order<X: Axes>(code: u32) -> ([usize; MAX_AXES], usize) {
    let mut axes = [0; MAX_AXES];
    match code {
        ALL | LAST if X::RANK == 0 => (axes, 1),
        ALL => {
            let mut a = 0;
            while a < X::RANK {
                axes[a] = a;
                a += 1;
            }
            (axes, X::RANK)
        }
        LAST => {
            axes[0] = X::RANK - 1;
            (axes, 1)
        }
        _ => {
            let (mut rest, mut count) = (code, 0);
            while rest > 0 {
                count += 1;
                rest >>= 4;
            }
            let mut n = 0;
            while n < count {
                axes[n] = ((code >> (4 * (count - 1 - n))) & 0xf) as usize - 1;
                assert!(axes[n] < X::RANK, "the layout names an axis that the field does not have");
                n += 1;
            }
            (axes, count)
        }
    }
}

/// Every axis of the field, in order.
pub const ALL: u32 = 0xffff_ffff;
/// The last axis of the field.
pub const LAST: u32 = 0xffff_fffe;
