//! The loop holds the field.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        u.fill(1.0);
        u[p] = 2.0;
    }
}

fn main() {}
