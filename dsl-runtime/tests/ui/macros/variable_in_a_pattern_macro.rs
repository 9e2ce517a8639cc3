//! A macro in a pattern could bind the loop variable again.
use allotrope::prelude::*;

macro_rules! either {
    ($name:ident) => {
        Some($name)
    };
}

#[kernel]
fn fill(u: &mut Field<f32, _>, near: Option<i32>) {
    for p in u {
        if let either!(p) = near {
            u[p] = 1.0;
        }
    }
}

fn main() {}
