//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, near: Option<i32>) {
    for p in u {
        while let Some(p) = near {
            u[p] = 1.0;
        }
    }
}

fn main() {}
