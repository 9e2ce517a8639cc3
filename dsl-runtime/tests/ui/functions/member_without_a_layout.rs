//! A member of a function has a layout, or any: `_`.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<f32>) -> f32 {
    q[0]
}

fn main() {}
