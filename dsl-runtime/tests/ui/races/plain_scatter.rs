//! A parallel loop writes at its own index.
use allotrope::prelude::*;

#[kernel]
fn reorder(a: &Field<f32, _>, perm: &Field<u32, _>, b: &mut Field<f32, _>) {
    for i in a {
        b[perm[i]] = a[i];
    }
}

#[kernel]
fn shift(a: &Field<f32, _>, b: &mut Field<f32, _>) {
    for i in a {
        b[i + 1] = a[i];
        b[0] = 2.0;
    }
}

#[kernel]
fn rows(u: &mut Field<f32, _, Ij>, sums: &mut Field<f32, _>) {
    for (i, j) in u {
        sums[i] = u[(i, j)];
    }
}

fn main() {}
