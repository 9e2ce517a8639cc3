//! A colour is taken of an interior, not an interior of a colour.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u.checkerboard(0).interior(1) {
        u[ij] = 0.0;
    }
}

fn main() {}
