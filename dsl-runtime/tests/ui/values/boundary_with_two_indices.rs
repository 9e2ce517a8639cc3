//! An index over two axes is one argument.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = u.clamped(i - 1, j);
    }
}

fn main() {}
