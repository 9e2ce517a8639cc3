//! A parallel loop writes at its own index.
use allotrope::prelude::*;

#[kernel]
fn last(a: &Field<f32, _>, b: &mut Field<f32, _>) {
    for i in a {
        b[0] = a[i];
    }
}

fn main() {}
