//! The remainder of a number below zero is below zero.
#![deny(deprecated)]
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _>, next: &mut Field<f32, _>, n: i32) {
    for i in next {
        next[i] = u[(i - 1) % n] + u[(i + 1) % n];
    }
}

fn main() {}
