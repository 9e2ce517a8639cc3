//! An index over several axes is one tuple.
use allotrope::prelude::*;

#[kernel]
fn read(u: &mut Field<f32, _, Ij>, v: &Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, j)] = v.clamped(i - 1, j);
    }
}

fn main() {}
