//! `unroll!` has a name for each range.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        for o in unroll!(0..3, 0..3) {
            u[p] += o as f32;
        }
    }
}

fn main() {}
