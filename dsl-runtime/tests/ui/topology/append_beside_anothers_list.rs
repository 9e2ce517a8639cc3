//! Only the own list can be read beside `append`.
use allotrope::prelude::*;

#[kernel]
fn wrong(points: &Field<f32, _>, near: &mut Field<u32, _, Ij>, last: &mut Field<u32, _>) {
    for p in points {
        near.append(p, 7);
        last[p] = near[(p + 1, 0)];
    }
}

fn main() {}
