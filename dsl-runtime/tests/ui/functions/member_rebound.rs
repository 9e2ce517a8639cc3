//! The name of a member stands for it alone.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<Vec2, _>, i: i32) -> f32 {
    let q = q[i];
    q.x
}

fn main() {}
