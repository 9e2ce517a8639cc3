//! Ranges are half-open.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: usize) {
    for i in 0..=n {
        u[i] = 1.0;
    }
}

fn main() {}
