//! `dense`: a full block of cells, the one node that has no state.

use super::node::{Digit, Inner, chain, order, product, sizes};
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;

/// `dense(ij, (4, 2))`: a full block over the axes of `ORDER` in that order of memory, of `A` cells along `i`, `B` along
/// `j`, `C` along `k`, `D` along `l`.
#[derive(Clone, Copy, Debug)]
pub struct Dense<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N>(
    core::marker::PhantomData<fn() -> N>,
);

impl<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N> Sealed
    for Dense<ORDER, A, B, C, D, N>
{
}

/// How many of the node's cells lie between neighbours along each axis.
const fn strides<X: Axes>(code: u32, sizes: PerAxis) -> PerAxis {
    let (axes, count) = order::<X>(code);
    let (mut strides, mut n, mut stride) = ([0; MAX_AXES], count, 1);
    while n > 0 {
        n -= 1;
        strides[axes[n]] = stride;
        stride *= sizes[axes[n]];
    }
    strides
}

impl<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N, X> Inner<X>
    for Dense<ORDER, A, B, C, D, N>
where
    N: Inner<X>,
    X: Axes,
{
    type Place = N::Place;
    const EXTENT: PerAxis = {
        let own = sizes::<X>(ORDER, [A, B, C, D]);
        [own[0] * N::EXTENT[0], own[1] * N::EXTENT[1], own[2] * N::EXTENT[2], own[3] * N::EXTENT[3]]
    };
    const CELLS: usize = product(sizes::<X>(ORDER, [A, B, C, D])) * N::CELLS;
    const LEAF: usize = if N::LEAF == 0 { product(sizes::<X>(ORDER, [A, B, C, D])) } else { N::LEAF };
    const RUN_AXIS: usize = if N::LEAF == 0 {
        let (axes, count) = order::<X>(ORDER);
        axes[count - 1]
    } else {
        N::RUN_AXIS
    };
    const RUN: usize =
        if N::LEAF == 0 { sizes::<X>(ORDER, [A, B, C, D])[<Self as Inner<X>>::RUN_AXIS] } else { N::RUN };
    const ROWS: usize = <Self as Inner<X>>::CELLS / <Self as Inner<X>>::RUN;
    const DIGITS: &'static [Digit] =
        &chain(Digit { order: ORDER, sizes: sizes::<X>(ORDER, [A, B, C, D]), curve: false }, N::DIGITS);
    const GRAIN: usize = N::GRAIN;

    #[inline(always)]
    fn term(axis: usize, c: usize, leaf_bytes: usize, stride: usize) -> usize {
        let cell = N::CELLS.checked_div(N::LEAF).map_or(stride, |leaves| leaves * leaf_bytes);
        let step = const { &strides::<X>(ORDER, sizes::<X>(ORDER, [A, B, C, D])) }[axis] * cell;
        let below = const { &N::EXTENT }[axis];
        if N::LEAF == 0 || below == 1 {
            return c * step;
        }
        // Divisions are made in 32 bits, which vectorise: extents are below 2^31.
        let (c, below) = (c as u32, below as u32);
        (c / below) as usize * step + N::term(axis, (c % below) as usize, leaf_bytes, stride)
    }
}
