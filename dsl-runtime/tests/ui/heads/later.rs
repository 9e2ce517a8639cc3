//! Heads and attributes that this version lacks.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u.row(0) {
        u[(i, j)] = 0.0;
    }
    #[relaxed]
    for ij in u {
        u[ij] = 1.0;
    }
}

fn main() {}
