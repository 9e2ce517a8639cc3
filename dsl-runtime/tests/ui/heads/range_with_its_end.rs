//! Ranges are half-open.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for i in 0..=9 {
        u[i] = 1.0;
    }
}

fn main() {}
