//! An own index is the variable itself.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for ij in u {
        u[(ij.x, ij.y)] = 1.0;
    }
}

fn main() {}
