//! A parallel loop names its field.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for i in &u {
        u[i] = 1.0;
    }
}

fn main() {}
