//! An element has one colour.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u.checkerboard(0).colored(2, 1) {
        u[ij] = 0.0;
    }
}

fn main() {}
