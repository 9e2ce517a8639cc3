//! A loop over a larger field clamps by more than one step.
use allotrope::prelude::*;

#[kernel]
fn relax(u: &mut Field<f32, _, Ij>, v: &Field<f32, _, Ij>) {
    for (i, j) in v.checkerboard(0) {
        u[(i, j)] = u.clamped((i + 1, j));
    }
}

fn main() {}
