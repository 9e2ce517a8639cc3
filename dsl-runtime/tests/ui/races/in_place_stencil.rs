//! A member that is written at the own index is not read at others.
use allotrope::prelude::*;

#[kernel]
fn smooth(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u.interior(1) {
        u[(i, j)] = 0.25 * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]);
    }
}

fn main() {}
