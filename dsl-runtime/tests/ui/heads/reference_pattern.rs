//! A loop names its index.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for &p in u {
        u[p] = 1.0;
    }
}

fn main() {}
