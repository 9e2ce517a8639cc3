//! What comes twice would be written twice.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for i in [0, 0, 1] {
        u[i] = 1.0;
    }
}

fn main() {}
