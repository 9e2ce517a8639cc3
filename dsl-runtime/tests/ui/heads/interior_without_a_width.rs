//! A border has a width.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u.interior() {
        u[ij] = 0.0;
    }
}

fn main() {}
