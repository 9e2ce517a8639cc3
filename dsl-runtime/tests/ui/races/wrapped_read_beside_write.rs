//! A read with a boundary rule is a read of any element.
use allotrope::prelude::*;

#[kernel]
fn rotate(u: &mut Field<f32, _>) {
    for p in u {
        u[p] = u.wrapped(p + 1);
    }
}

fn main() {}
