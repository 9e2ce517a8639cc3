//! Closures are looked into.
use allotrope::prelude::*;

#[kernel]
fn smooth(u: &mut Field<f32, _>) {
    for p in u {
        let left = || u[p - 1];
        u[p] = left();
    }
}

fn main() {}
