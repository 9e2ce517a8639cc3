//! A reduction is not read in its loop.
use allotrope::prelude::*;

#[kernel]
fn double(u: &Field<f32, _>) -> f32 {
    let mut total = 1.0;
    for p in u {
        total += u[p] * total;
    }
    total
}

fn main() {}
