//! A random number is a function of its seed and its key.
#![deny(deprecated)]
use allotrope::prelude::*;

#[kernel]
fn wrong(x: &mut Field<Vec2, _>, seed: u64) {
    for p in x {
        x[p] = vec2(
            random(seed, p),
            random(seed, p),
        );
    }
}

fn main() {}
