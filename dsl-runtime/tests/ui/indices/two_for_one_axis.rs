//! An index has as many places as its field has axes.
use allotrope::prelude::*;

#[kernel]
fn copy(u: &Field<f32, _>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = u[(i, j)];
    }
}

fn main() {}
