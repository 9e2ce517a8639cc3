//! A field keeps its name.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    for p in u {
        let v = v[p];
        u[p] = v;
    }
}

fn main() {}
