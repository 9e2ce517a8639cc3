//! A loop names its index.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ijk>) {
    for (i, (j, k)) in u {
        u[(i, j, k)] = 1.0;
    }
}

fn main() {}
