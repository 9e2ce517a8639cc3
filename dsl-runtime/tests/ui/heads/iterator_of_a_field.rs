//! A parallel loop runs over a field's indices, not over its values.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for (i, x) in u.iter().enumerate() {
        v[i] = x;
    }
}

fn main() {}
