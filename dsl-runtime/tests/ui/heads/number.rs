//! A parallel loop runs over a range.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: usize) {
    for i in n {
        u[i] = 1.0;
    }
}

fn main() {}
