//! A function adds nothing to members.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<f32, _>, i: i32) {
    q[i] += 1.0;
}

fn main() {}
