//! A function takes a member by value.
use allotrope::prelude::*;

#[func]
fn wrong(q: &Read<f32, _>) -> f32 {
    q[0]
}

fn main() {}
