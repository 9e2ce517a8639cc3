//! Cells of one side over a box.

use allotrope::spatial::*;

use super::Options;

/// The most cells along an axis: numbers of cells are told in single precision, to `2^-24` of the axis.
const MOST_ALONG: f32 = 4096.0;

/// The most cells in all for each particle, beside a thousand.
const MOST_EACH: f64 = 16.0;

/// Cells of one side over a box. What lies beyond the box belongs to the cells at its border, so that near places still
/// lie in cells beside each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells<X: Spatial> {
    lower: X::Vec<f32>,
    inv_side: f32,
    /// Cells along each axis.
    counts: X::Index,
}

impl<X: Spatial> Cells<X> {
    /// Cells over the options' box that are at least as wide as the radius and its skin.
    pub(super) fn new(options: &Options<X>) -> Self {
        let extent = (options.upper - options.lower).max(X::Vec::<f32>::splat(f32::MIN_POSITIVE));
        let longest = (0..X::RANK).map(|axis| extent[axis]).fold(0.0, f32::max);
        let mut side = cell_side(options).max(longest / MOST_ALONG);
        let along = |side: f32, axis: usize| (extent[axis] / side).floor().max(1.0);
        // A box that is mostly empty has coarser cells rather than more than can be held.
        let most = 1000.0 + MOST_EACH * options.particles as f64;
        while (0..X::RANK).map(|axis| f64::from(along(side, axis))).product::<f64>() > most {
            side *= 1.25;
        }
        Self {
            lower: options.lower,
            inv_side: side.recip(),
            counts: X::Index::from_fn(|axis| along(side, axis) as i32),
        }
    }

    /// The cell of a place.
    #[inline(always)]
    pub fn cell(&self, x: X::Vec<f32>) -> X::Index {
        // Rounded towards zero, which below the box is the first cell, as it should be.
        ((x - self.lower) * self.inv_side).to_index().max(X::Index::splat(0)).min(self.counts - 1)
    }

    /// The number of a cell, row by row.
    #[inline(always)]
    pub fn number(&self, cell: X::Index) -> i32 {
        let row = if X::RANK > 2 { cell[0] * self.counts[1] + cell[1] } else { cell[0] };
        row * self.counts[X::RANK - 1] + cell[X::RANK - 1]
    }

    /// How many cells there are.
    pub fn len(&self) -> usize {
        (0..X::RANK).map(|axis| self.counts[axis] as usize).product()
    }

    /// Whether there are none, which never is.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Calls `visit` with the first and last cell of each row of those around a place.
    #[inline(always)]
    pub(super) fn rows(&self, x: X::Vec<f32>, mut visit: impl FnMut(i32, i32)) {
        let cell = self.cell(x);
        let low = (cell - 1).max(X::Index::splat(0));
        let high = (cell + 1).min(self.counts - 1);
        let last = X::RANK - 1;
        // A plane is a space of one layer.
        let (first, columns) = if X::RANK > 2 { (low[0]..high[0] + 1, self.counts[1]) } else { (0..1, 0) };
        for i in first {
            for j in low[last - 1]..high[last - 1] + 1 {
                let row = (i * columns + j) * self.counts[last];
                visit(row + low[last], row + high[last]);
            }
        }
    }
}

/// The side of cells in which all that is near lies in cells beside each other, in spite of rounding.
pub(super) fn cell_side<X: Spatial>(options: &Options<X>) -> f32 {
    (options.radius + options.skin) * 1.001
}
