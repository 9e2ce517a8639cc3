//! A field has no value in a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn copy(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    for p in u {
        u[p] = ({ v })[p];
    }
}

fn main() {}
