//! Ranges have both ends.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for i in 1.. {
        u[i] = 1.0;
    }
}

fn main() {}
