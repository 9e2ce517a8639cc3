//! `unroll!` takes ranges.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        for i in unroll!(3) {
            u[p] += i as f32;
        }
    }
}

fn main() {}
