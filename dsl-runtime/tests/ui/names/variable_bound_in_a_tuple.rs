//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        let (j, x) = (0, 1.0);
        u[(i, j)] = x;
    }
}

fn main() {}
