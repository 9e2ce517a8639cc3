//! An own index has all variables of its loop.
use allotrope::prelude::*;

#[kernel]
fn rows(u: &Field<f32, _, Ij>, sums: &mut Field<f32, _>) {
    for (i, j) in u {
        sums[i] = u[(i, j)];
    }
}

fn main() {}
