//! A single member is no other than a field.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Member<f32, _, Ij>) {
    for (i, j) in u.interior(1) {
        u[(i, j)] = u[(i - 1, j)];
    }
}

fn main() {}
