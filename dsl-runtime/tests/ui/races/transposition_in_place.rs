//! The variables of a loop keep their places.
use allotrope::prelude::*;

#[kernel]
fn transpose(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, j)] = u[(j, i)];
    }
}

fn main() {}
