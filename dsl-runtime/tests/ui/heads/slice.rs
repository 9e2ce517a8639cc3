//! A parallel loop runs over indices.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, ids: &[usize]) {
    for i in ids.iter() {
        u[*i] = 1.0;
    }
}

fn main() {}
