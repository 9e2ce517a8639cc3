//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        for p in 0..3 {
            u[p] = 1.0;
        }
    }
}

fn main() {}
