//! A member is borrowed.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: Member<f32, _, Ij>) {}

fn main() {}
