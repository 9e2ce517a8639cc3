//! Offsets stay within the border that is left out.
use allotrope::prelude::*;

#[kernel]
fn wide(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for ij in v.interior(1).checkerboard(0) {
        v[ij] = u[ij + ivec2(0, 2)];
    }
}

fn main() {}
