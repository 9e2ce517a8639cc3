//! A read with a boundary rule is a read of any element.
use allotrope::prelude::*;

#[kernel]
fn smooth(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, j)] = 0.5 * (u.clamped((i - 1, j)) + u.clamped((i + 1, j)));
    }
}

fn main() {}
