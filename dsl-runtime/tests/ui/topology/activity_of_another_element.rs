//! Another iteration may be making it active.
use allotrope::prelude::*;

#[kernel]
fn wrong(grid: &mut Field<f32, _, Ij>) {
    for ij in grid {
        if !grid.is_active(ij + ivec2(1, 0)) {
            grid.activate(ij + ivec2(0, 1));
        }
    }
}

fn main() {}
