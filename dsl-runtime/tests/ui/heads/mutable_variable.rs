//! A loop variable keeps its value.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for mut p in u {
        p = 0;
        u[p] = 1.0;
    }
}

fn main() {}
