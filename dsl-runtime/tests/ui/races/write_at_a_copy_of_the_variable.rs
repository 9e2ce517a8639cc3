//! An own index is the variable itself.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        let here = p;
        u[here] = 1.0;
    }
}

fn main() {}
