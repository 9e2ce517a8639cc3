//! A parallel loop has no order.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: usize) {
    for i in (0..n).rev() {
        u[i] = 1.0;
    }
}

fn main() {}
