//! `unroll!` runs over constants.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>, n: i32) {
    for p in u {
        for (i, j) in unroll!(0..n, 0..3) {
            u[p] += (i * j) as f32;
        }
    }
}

fn main() {}
