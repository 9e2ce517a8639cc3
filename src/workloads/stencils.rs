//! Jacobi's 5-point step and the 7-point Laplacian.

use allotrope::prelude::*;

/// Four values a cell, of which one takes part: what a layout does to a member among others.
#[derive(Record, Clone, Copy, Default)]
pub struct Four {
    /// The one that takes part.
    pub u: f32,
    /// Another.
    pub a: f32,
    /// Another.
    pub b: f32,
    /// Another.
    pub c: f32,
}

/// One Jacobi step.
#[kernel]
pub fn jacobi(a: f32, u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v.interior(1) {
        v[(i, j)] = a * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]);
    }
}

/// One Jacobi step of one member of four.
#[kernel]
pub fn jacobi_member(a: f32, u: &Field<Four, _, Ij>, v: &mut Field<Four, _, Ij>) {
    for (i, j) in v.interior(1) {
        v.u[(i, j)] = a * (u.u[(i - 1, j)] + u.u[(i + 1, j)] + u.u[(i, j - 1)] + u.u[(i, j + 1)]);
    }
}

/// The 7-point Laplacian.
#[kernel]
pub fn laplacian(p: &Field<f32, _, Ijk>, q: &mut Field<f32, _, Ijk>) {
    for (i, j, k) in q.interior(1) {
        q[(i, j, k)] = p[(i - 1, j, k)]
            + p[(i + 1, j, k)]
            + p[(i, j - 1, k)]
            + p[(i, j + 1, k)]
            + p[(i, j, k - 1)]
            + p[(i, j, k + 1)]
            - 6.0 * p[(i, j, k)];
    }
}

/// Values that differ from cell to cell.
pub fn ramp(cells: usize) -> Vec<f32> {
    (0..cells).map(|n| (n * 7919 % 1009) as f32 / 1009.0).collect()
}
