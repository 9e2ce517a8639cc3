//! An entry of a tuple is a reduction of its own.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _>) -> ((i32, i32), f32) {
    let mut counts = ((0, 0), 0.0);
    for p in u {
        counts.0.1 += 1;
        counts.1 += u[p];
        counts.0 += (1, 0);
    }
    counts
}

fn main() {}
