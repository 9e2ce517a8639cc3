//! A border's width is `u32` (H22).
use allotrope::prelude::*;

#[kernel]
fn border(u: &mut Field<f32, _>) {
    for p in u.interior(-1) { //~ E0277
        u[p] = 1.0;
    }
}

fn main() {}
