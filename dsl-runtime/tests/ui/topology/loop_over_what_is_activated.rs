//! What is active changes while the inner loop runs.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, grid: &mut Field<f32, _, I>) {
    for p in keys {
        grid[keys[p]] += 1.0;
        for q in grid {
            assert!(q >= 0);
        }
    }
}

fn main() {}
