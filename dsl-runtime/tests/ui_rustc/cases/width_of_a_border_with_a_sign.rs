//! A border's width is `u32` (H22).
use allotrope::prelude::*;

#[kernel]
fn border(u: &mut Field<f32, _>, width: i32) {
    for p in u.interior(width) { //~ E0308
        u[p] = 1.0;
    }
}

fn main() {}
