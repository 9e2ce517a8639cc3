//! An own index has all variables of its loop.
use allotrope::prelude::*;

#[kernel]
fn diagonal(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, i)] = 1.0;
    }
}

fn main() {}
