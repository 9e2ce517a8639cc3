//! Variables from outside are accumulated into, not assigned.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _>, out: &mut f32) -> f32 {
    let mut last = 0.0;
    let mut ratio = 1.0;
    for p in u {
        last = u[p];
        ratio /= u[p];
        *out += u[p];
    }
    last + ratio
}

fn main() {}
