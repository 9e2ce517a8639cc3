//! `total = total + x` is no accumulation.
use allotrope::prelude::*;

#[kernel]
fn sum(u: &Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        total = total + u[p];
    }
    total
}

fn main() {}
