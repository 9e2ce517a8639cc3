//! A loop names its index.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _, Ij>) {
    for IVec2 { x, y } in u {
        u[(x, y)] = 1.0;
    }
}

fn main() {}
