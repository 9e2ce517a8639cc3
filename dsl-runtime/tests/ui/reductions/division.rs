//! Variables from outside are accumulated into, not assigned.
use allotrope::prelude::*;

#[kernel]
fn ratio(u: &Field<f32, _>) -> f32 {
    let mut ratio = 1.0;
    for p in u {
        ratio /= u[p];
    }
    ratio
}

fn main() {}
