//! A tuple names each axis.
use allotrope::prelude::*;

#[kernel]
fn clear(v: &mut Field<f32, _, Ij>) {
    for (i, j, k) in v {
        v[(i, j)] = 0.0;
    }
}

fn main() {}
