//! `unroll!` is the head of a loop.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        let all = unroll!(0..3);
        u[p] += 1.0;
    }
}

fn main() {}
