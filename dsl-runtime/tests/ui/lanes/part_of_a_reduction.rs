//! Loops in lanes sum up whole variables.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn moments(x: &Field<f32, _>) -> Vec2 {
    let mut moments = Vec2::ZERO;
    for i in x {
        let mut power = 1.0;
        for _ in 0..3 {
            power *= x[i];
        }
        moments.x += power;
    }
    moments
}

fn main() {}
