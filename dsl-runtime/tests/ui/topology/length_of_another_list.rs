//! Another iteration may be appending to it.
use allotrope::prelude::*;

#[kernel]
fn wrong(points: &Field<f32, _>, near: &mut Field<u32, _, Ij>, before: &mut Field<u32, _>) {
    for p in points {
        near.append(p, 7);
        before[p] = near.len(p - 1) as u32;
    }
}

fn main() {}
