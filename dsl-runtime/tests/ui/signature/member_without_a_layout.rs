//! A member as a parameter names its values, its layout and its axes.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Member<f32>) {}

fn main() {}
