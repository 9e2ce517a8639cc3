//! A field keeps its name.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    let half = |v: f32| 0.5 * v;
    for p in u {
        u[p] = half(1.0);
    }
}

fn main() {}
