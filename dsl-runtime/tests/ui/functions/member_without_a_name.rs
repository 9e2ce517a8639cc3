//! Reads are found by the name of the member.
use allotrope::prelude::*;

#[func]
fn wrong(_: Read<f32, _>) -> f32 {
    0.0
}

fn main() {}
