//! The outermost loop is a launch.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for i in unroll!(0..3) {
        u[i] = 1.0;
    }
}

fn main() {}
