//! Parts of fields with other arguments than they take, or in an order that means nothing.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _, Ij>) {
    for ij in u.checkerboard() {
        u[ij] = 0.0;
    }
    for ij in u.checkerboard(0).interior(1) {
        u[ij] = 0.0;
    }
    for ij in u.checkerboard(0).colored(2, 1) {
        u[ij] = 0.0;
    }
}

fn main() {}
