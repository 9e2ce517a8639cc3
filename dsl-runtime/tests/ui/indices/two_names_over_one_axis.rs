//! A tuple names each axis.
use allotrope::prelude::*;

#[kernel]
fn clear(v: &mut Field<f32, _>) {
    for (i, j) in v {
        v[i] += j as f32;
    }
}

fn main() {}
