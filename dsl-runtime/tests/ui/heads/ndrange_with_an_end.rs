//! The ranges of `ndrange!` are half-open.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>, n: usize) {
    for (i, j) in ndrange!(0..n, 0..=n) {
        u[(i, j)] = 1.0;
    }
}

fn main() {}
