//! The variables of a loop keep their places.
use allotrope::prelude::*;

#[kernel]
fn border(u: &mut Field<f32, _, Ij>, n: i32) {
    for i in 0..n {
        u[(i, 0)] = 0.0;
        u[(0, i)] = 0.0;
    }
}

fn main() {}
