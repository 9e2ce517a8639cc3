//! The own index plus a constant is another's.
use allotrope::prelude::*;

#[kernel]
fn push(u: &mut Field<f32, _>) {
    for p in u {
        u[p + 1] += u[p];
    }
}

fn main() {}
