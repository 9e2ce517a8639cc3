//! Single members are no parameters yet.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &Member<f32, _, Ij>) {}

fn main() {}
