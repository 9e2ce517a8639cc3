//! Ranges are half-open.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, n: usize) {
    for i in 0..=9 {
        u[i] = 1.0;
    }
    for i in 0..=n {
        u[i] = 1.0;
    }
    for i in 1.. {
        u[i] = 1.0;
    }
}

fn main() {}
