//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        for (k, i) in unroll!(0..3, 0..3) {
            u[(i, j)] += k as f32;
        }
    }
}

fn main() {}
