//! A field to be written is taken by `&mut`.
use allotrope::prelude::*;

#[kernel]
fn first(u: &Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
