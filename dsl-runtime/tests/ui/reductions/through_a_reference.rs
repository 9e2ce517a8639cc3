//! What a parameter refers to is shared by all iterations.
use allotrope::prelude::*;

#[kernel]
fn sum(u: &Field<f32, _>, out: &mut f32) {
    for p in u {
        *out += u[p];
    }
}

fn main() {}
