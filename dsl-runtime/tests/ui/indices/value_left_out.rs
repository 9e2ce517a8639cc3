//! `or` takes an index and a value.
use allotrope::prelude::*;

#[kernel]
fn read(u: &mut Field<f32, _, Ij>, v: &Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, j)] = v.or((i - 1, j));
    }
}

fn main() {}
