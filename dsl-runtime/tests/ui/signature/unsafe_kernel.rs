//! A kernel promises by itself.
use allotrope::prelude::*;

#[kernel]
unsafe fn promise(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
