//! The options of kernels are a closed list.
use allotrope::prelude::*;

#[kernel(grad)]
fn fill(u: &mut Field<f32, _>) {}

fn main() {}
