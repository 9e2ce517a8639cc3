//! `morton`: a full block of cells in Z-order, so that cells which are near along any axis are near in memory.

use super::node::{Digit, Inner, chain, order, product, sizes};
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;

/// `morton(ij, 8)`: a full block over the axes of `ORDER` in Z-order, of `A` cells along `i`, `B` along `j`, `C` along
/// `k`, `D` along `l`, each a power of two.
///
/// The bits of a cell's place are those of its coordinates in turn, the last axis lowest; an axis whose bits are used up
/// is left out.
#[derive(Clone, Copy, Debug)]
pub struct Curve<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N>(
    core::marker::PhantomData<fn() -> N>,
);

impl<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N> Sealed
    for Curve<ORDER, A, B, C, D, N>
{
}

/// The most bits of a coordinate.
const BITS: usize = 32;

/// The sizes along the axes that the node names, of which each must have whole bits.
const fn powers<X: Axes>(code: u32, given: PerAxis) -> PerAxis {
    let sizes = sizes::<X>(code, given);
    let mut axis = 0;
    while axis < MAX_AXES {
        assert!(sizes[axis].is_power_of_two(), "the sizes of a `morton` block are powers of two");
        axis += 1;
    }
    sizes
}

/// Where each bit of each coordinate stands in a cell's number.
const fn shifts<X: Axes>(code: u32, sizes: PerAxis) -> [[u32; BITS]; MAX_AXES] {
    let (axes, count) = order::<X>(code);
    let (mut shifts, mut next, mut bit) = ([[0; BITS]; MAX_AXES], 0, 0);
    while bit < BITS {
        let mut n = count;
        while n > 0 {
            n -= 1;
            if bit < sizes[axes[n]].trailing_zeros() as usize {
                shifts[axes[n]][bit] = next;
                next += 1;
            }
        }
        bit += 1;
    }
    shifts
}

/// The coordinates of the cell of a number.
#[inline(always)]
pub(super) const fn place<X: Axes>(code: u32, sizes: PerAxis, number: usize) -> PerAxis {
    let (axes, count) = order::<X>(code);
    let (mut at, mut rest, mut left, mut bit) = ([0; MAX_AXES], number, product(sizes), 0);
    while left > 1 {
        let mut n = count;
        while n > 0 {
            n -= 1;
            if sizes[axes[n]] >> bit > 1 {
                at[axes[n]] |= (rest & 1) << bit;
                rest >>= 1;
                left >>= 1;
            }
        }
        bit += 1;
    }
    at
}

impl<const ORDER: u32, const A: usize, const B: usize, const C: usize, const D: usize, N, X> Inner<X>
    for Curve<ORDER, A, B, C, D, N>
where
    N: Inner<X>,
    X: Axes,
{
    type Place = N::Place;
    const EXTENT: PerAxis = {
        let own = powers::<X>(ORDER, [A, B, C, D]);
        [own[0] * N::EXTENT[0], own[1] * N::EXTENT[1], own[2] * N::EXTENT[2], own[3] * N::EXTENT[3]]
    };
    const CELLS: usize = product(powers::<X>(ORDER, [A, B, C, D])) * N::CELLS;
    const LEAF: usize = if N::LEAF == 0 { product(powers::<X>(ORDER, [A, B, C, D])) } else { N::LEAF };
    const RUN_AXIS: usize = if N::LEAF == 0 {
        let (axes, count) = order::<X>(ORDER);
        axes[count - 1]
    } else {
        N::RUN_AXIS
    };
    // Only pairs along the last axis lie one after another, unless there is no other axis.
    const RUN: usize = if N::LEAF == 0 {
        let sizes = powers::<X>(ORDER, [A, B, C, D]);
        let size = sizes[<Self as Inner<X>>::RUN_AXIS];
        if size == product(sizes) || size < 2 { size } else { 2 }
    } else {
        N::RUN
    };
    const ROWS: usize = <Self as Inner<X>>::CELLS / <Self as Inner<X>>::RUN;
    const DIGITS: &'static [Digit] =
        &chain(Digit { order: ORDER, sizes: powers::<X>(ORDER, [A, B, C, D]), curve: true }, N::DIGITS);
    const GRAIN: usize = N::GRAIN;

    #[inline(always)]
    fn term(axis: usize, c: usize, leaf_bytes: usize, stride: usize) -> usize {
        let cell = N::CELLS.checked_div(N::LEAF).map_or(stride, |leaves| leaves * leaf_bytes);
        let shifts = const { &shifts::<X>(ORDER, powers::<X>(ORDER, [A, B, C, D])) }[axis];
        let bits = const { &powers::<X>(ORDER, [A, B, C, D]) }[axis].trailing_zeros() as usize;
        let below = const { &N::EXTENT }[axis] as u32;
        // In 32 bits, which vectorise, as in `dense`.
        let (c, mut number) = (c as u32, 0);
        for (bit, shift) in shifts.iter().take(bits).enumerate() {
            number |= (((c / below) >> bit) & 1) << shift;
        }
        let below = if below == 1 { 0 } else { N::term(axis, (c % below) as usize, leaf_bytes, stride) };
        number as usize * cell + below
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axes::{Ij, Ijk};

    #[test]
    fn bits_alternate_from_the_last_axis_up() {
        let places: Vec<_> = (0..8).map(|n| place::<Ij>(0x12, [4, 2, 1, 1], n)[..2].to_vec()).collect();
        assert_eq!(places, [[0, 0], [0, 1], [1, 0], [1, 1], [2, 0], [2, 1], [3, 0], [3, 1]]);
        let places: Vec<_> = (0..8).map(|n| place::<Ijk>(0x312, [2, 2, 2, 1], n)[..3].to_vec()).collect();
        assert_eq!(places[1..5], [[0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]]);
    }

    #[test]
    fn places_and_terms_are_inverse() {
        type Block = Curve<0x213, 4, 8, 2, 1, crate::layout::PlaceAos>;
        for number in 0..64 {
            let at = place::<Ijk>(0x213, [4, 8, 2, 1], number);
            let terms: usize = (0..3).map(|axis| <Block as Inner<Ijk>>::term(axis, at[axis], 0, 1)).sum();
            assert_eq!(terms, number);
        }
    }
}
