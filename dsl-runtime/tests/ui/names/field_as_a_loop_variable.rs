//! A field keeps its name.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    for v in u {
        u[v] = 1.0;
    }
}

fn main() {}
