//! An inner variable is no loop's own.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    for p in v {
        for k in 0..4 {
            u[k] = v[p];
        }
    }
}

fn main() {}
