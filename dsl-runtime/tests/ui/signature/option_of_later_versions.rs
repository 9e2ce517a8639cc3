//! The options of kernels are a closed list.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn fill(u: &mut Field<f32, _>) {}

fn main() {}
