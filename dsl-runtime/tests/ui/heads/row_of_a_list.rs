//! A field of this version has no lists in its cells.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u.row(0) {
        u[(i, j)] = 0.0;
    }
}

fn main() {}
