//! `unroll!` has a name for each range.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        for (i, j) in unroll!(0..3) {
            u[p] += (i + j) as f32;
        }
    }
}

fn main() {}
