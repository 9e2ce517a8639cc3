//! The loop holds the field.
use allotrope::prelude::*;

#[kernel]
fn wrong(grid: &mut Field<f32, _, Ij>) {
    for ij in grid {
        grid[ij] = 1.0;
        grid.clear();
    }
}

fn main() {}
