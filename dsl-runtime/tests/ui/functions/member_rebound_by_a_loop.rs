//! The name of a member is no loop variable.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<f32, _>) -> f32 {
    let mut sum = 0.0;
    for q in 0..3 {
        sum += q as f32;
    }
    sum + q[0]
}

fn main() {}
