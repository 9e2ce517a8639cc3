//! `or` takes the value for what lies outside.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = u.or((i - 1, j));
    }
}

fn main() {}
