//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        let square = |p: i32| p * p;
        u[p] = square(3) as f32;
    }
}

fn main() {}
