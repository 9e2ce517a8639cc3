//! The loop writes the transposed element.
use allotrope::prelude::*;

#[kernel]
fn relax(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u.checkerboard(0) {
        u[(j, i)] = 0.5 * u[(i + 1, j)];
    }
}

fn main() {}
