//! A parallel loop runs over a plain range.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: usize) {
    for i in (0..n).step_by(2) {
        u[i] = 1.0;
    }
}

fn main() {}
