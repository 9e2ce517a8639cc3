//! A field has no value in a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn choose(u: &mut Field<f32, _>, v: &Field<f32, _>, w: &Field<f32, _>) {
    for p in u {
        u[p] = (if p > 3 { v } else { w })[p];
    }
}

fn main() {}
