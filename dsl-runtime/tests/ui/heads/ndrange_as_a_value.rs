//! `ndrange!` is the head of a loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>, n: usize) {
    let all = ndrange!(0..n, 0..n);
}

fn main() {}
