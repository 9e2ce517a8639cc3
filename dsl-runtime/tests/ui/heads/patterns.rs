//! The pattern of a parallel loop is a name or a tuple of names.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, v: &mut Field<f32, _, Ij>) {
    for mut p in u {
        p = 0;
        u[p] = 1.0;
    }
    for (i, mut j) in v {
        j += 1;
        v[(i, j)] = 1.0;
    }
    for IVec2 { x, y } in v {
        v[(x, y)] = 1.0;
    }
}

fn main() {}
