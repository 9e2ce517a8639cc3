//! A parallel loop writes at its own index.
use allotrope::prelude::*;

#[kernel]
fn reorder(a: &Field<f32, _>, perm: &Field<u32, _>, b: &mut Field<f32, _>) {
    for i in a {
        b[perm[i]] = a[i];
    }
}

fn main() {}
