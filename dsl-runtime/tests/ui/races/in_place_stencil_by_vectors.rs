//! A member that is written at the own index is not read at others.
use allotrope::prelude::*;

#[kernel]
fn smooth(u: &mut Field<f32, _, Ij>) {
    for ij in u.interior(1) {
        u[ij] = 0.5 * (u[ij - IVec2::X] + u[ij + ivec2(1, 0)]);
    }
}

fn main() {}
