//! A checkerboard has two colours.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u.checkerboard() {
        u[ij] = 0.0;
    }
}

fn main() {}
