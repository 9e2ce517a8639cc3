//! A macro that is not known may do anything with a member.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<f32, _>, i: i32) -> f32 {
    mine!(q, i)
}

fn main() {}
