//! An assignment has no value.
use allotrope::prelude::*;

#[kernel]
fn both(u: &mut Field<f32, _>) {
    for p in u {
        let x = (u[p] = 1.0);
    }
}

fn main() {}
