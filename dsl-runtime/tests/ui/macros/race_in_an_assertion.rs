//! Macros of the standard library are read as expressions.
use allotrope::prelude::*;

#[kernel]
fn show(u: &mut Field<f32, _>) {
    for p in u {
        u[p] = 1.0;
        assert!(matches!(u[p - 1], x if x > 0.0));
    }
}

fn main() {}
