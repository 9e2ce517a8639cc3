//! Colours are those of a modulus.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u.colored(1) {
        u[ij] = 0.0;
    }
}

fn main() {}
