//! A kernel starts threads.
use allotrope::prelude::*;

#[kernel]
const fn constant(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
