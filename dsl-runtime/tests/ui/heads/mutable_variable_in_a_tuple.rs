//! A loop variable keeps its value.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for (i, mut j) in u {
        j += 1;
        u[(i, j)] = 1.0;
    }
}

fn main() {}
