//! A function takes no options.
use allotrope::prelude::*;

#[func(fast)]
fn wrong(x: f32) -> f32 {
    x
}

fn main() {}
