//! An own index has its variables bare.
use allotrope::prelude::*;

#[kernel]
fn spread(u: &mut Field<f32, _>, n: i32) {
    for i in 0..n {
        u[2 * i] = 1.0;
    }
}

fn main() {}
