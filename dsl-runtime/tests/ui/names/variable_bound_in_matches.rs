//! A loop variable means one thing in its loop, in known macros too.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, near: Option<i32>) {
    for p in u {
        assert!(matches!(near, Some(p) if p > 0));
        u[p] = 1.0;
    }
}

fn main() {}
