//! `ndrange!` takes ranges.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>, n: usize, m: usize) {
    for (i, j) in ndrange!(n, m) {
        u[(i, j)] = 1.0;
    }
}

fn main() {}
