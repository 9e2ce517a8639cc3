//! A parallel loop names its field.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for x in &mut *u {
        u[x] = 1.0;
    }
}

fn main() {}
