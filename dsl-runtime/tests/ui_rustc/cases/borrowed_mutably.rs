//! A value read from a field is a copy: changing it in place would be lost (H25).
use allotrope::prelude::*;

#[kernel]
fn stop(x: &mut Field<Vec2, _>) {
    for p in x {
        let here = &mut x[p]; //~ E0596
        *here = Vec2::ZERO;
    }
}

fn main() {}
