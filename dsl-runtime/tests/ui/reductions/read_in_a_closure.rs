//! A reduction is not read in its loop.
use allotrope::prelude::*;

#[kernel]
fn running(u: &mut Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        let mean = |n: f32| total / n;
        u[p] = mean(3.0);
        total += 1.0;
    }
    total
}

fn main() {}
