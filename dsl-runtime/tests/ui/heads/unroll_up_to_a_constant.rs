//! `unroll!` sees no values.
use allotrope::prelude::*;

const N: i32 = 3;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        for i in unroll!(0..N) {
            u[p] += i as f32;
        }
    }
}

fn main() {}
