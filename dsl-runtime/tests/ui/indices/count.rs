//! An index has as many places as its field has axes.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, v: &mut Field<f32, _, Ij>) {
    for p in u {
        u[p] = v[p];
    }
    for (i, j) in v {
        v[(i, j)] = u[(i, j)];
    }
    for (i, j, k) in v {
        v[(i, j, k)] = 0.0;
    }
    v[0] = 1.0;
}

fn main() {}
