//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, k: i32) {
    for p in u {
        match k {
            p => u[p] = 1.0,
        }
    }
}

fn main() {}
