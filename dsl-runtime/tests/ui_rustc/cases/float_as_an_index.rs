//! Indices are integers.
use allotrope::prelude::*;

#[kernel]
fn indices(u: &mut Field<f32, _>, x: f32) {
    let _ = u[x]; //~ E0277
}

fn main() {}
