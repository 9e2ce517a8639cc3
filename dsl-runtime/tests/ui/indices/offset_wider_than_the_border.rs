//! Offsets stay within the border that is left out.
use allotrope::prelude::*;

#[kernel]
fn wide(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v.interior(1) {
        v[(i, j)] = u[(i - 2, j)] + u[(i, j + 1)];
    }
}

fn main() {}
