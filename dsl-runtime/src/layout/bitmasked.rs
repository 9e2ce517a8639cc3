//! `bitmasked`: a full block with one activity bit a cell.

use super::node::{Digit, Inner, product};
use crate::axes::{Axes, PerAxis};
use crate::element::Sealed;

/// `bitmasked(ij, 8)`: the block `N` with one activity bit for each of its cells. The bits stand behind the records of the whole block.
#[derive(Clone, Copy, Debug)]
pub struct Masked<N>(core::marker::PhantomData<fn() -> N>);
impl<N> Sealed for Masked<N> {}

impl<N: Inner<X>, X: Axes> Inner<X> for Masked<N> {
    type Place = N::Place;
    const EXTENT: PerAxis = N::EXTENT;
    const CELLS: usize = N::CELLS;
    const LEAF: usize = N::LEAF;
    const RUN: usize = N::RUN;
    const RUN_AXIS: usize = N::RUN_AXIS;
    const ROWS: usize = N::ROWS;
    const DIGITS: &'static [Digit] = N::DIGITS;
    const GRAIN: usize = {
        assert!(N::GRAIN == 0, "one node of a layout has the activity bits: the innermost");
        N::CELLS / product(N::DIGITS[0].sizes)
    };

    #[inline(always)]
    fn term(axis: usize, c: usize, leaf_bytes: usize, stride: usize) -> usize {
        N::term(axis, c, leaf_bytes, stride)
    }
}
