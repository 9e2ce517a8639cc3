//! The values of a member have a type.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<_, _, Ij>) -> f32 {
    q[(0, 0)]
}

fn main() {}
