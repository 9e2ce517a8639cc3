//! A field to be written is taken by `&mut`.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &Field<f32, _>) {
    for p in u {
        u[p] = 1.0;
    }
}

fn main() {}
