//! Fields are not bound to variables.
use allotrope::prelude::*;

#[kernel]
fn alias(u: &mut Field<f32, _>) {
    for p in u {
        let same = &mut *u;
        same[p] = 1.0;
    }
}

fn main() {}
