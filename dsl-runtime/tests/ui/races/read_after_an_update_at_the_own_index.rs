//! An own `+=` is a write.
use allotrope::prelude::*;

#[kernel]
fn running(u: &mut Field<f32, _>) {
    for p in u {
        u[p] += u[p - 1];
    }
}

fn main() {}
