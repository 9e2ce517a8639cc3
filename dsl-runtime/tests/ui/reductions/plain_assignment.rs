//! Variables from outside are accumulated into, not assigned.
use allotrope::prelude::*;

#[kernel]
fn last(u: &Field<f32, _>) -> f32 {
    let mut last = 0.0;
    for p in u {
        last = u[p];
    }
    last
}

fn main() {}
