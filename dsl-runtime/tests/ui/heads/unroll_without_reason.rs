//! What is unrolled is compiled.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        for (i, j) in unroll!(0..1000, 0..1000) {
            u[p] += (i * j) as f32;
        }
    }
}

fn main() {}
