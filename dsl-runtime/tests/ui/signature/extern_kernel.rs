//! A kernel's fields are Rust's.
use allotrope::prelude::*;

#[kernel]
extern "C" fn foreign(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
