//! A parallel loop writes at its own index.
use allotrope::prelude::*;

#[kernel]
fn shift(a: &Field<f32, _>, b: &mut Field<f32, _>) {
    for i in a {
        b[i + 1] = a[i];
    }
}

fn main() {}
