//! Every branch is looked into.
use allotrope::prelude::*;

#[kernel]
fn choose(u: &mut Field<f32, _>, kind: &Field<u32, _>) {
    for p in kind {
        match kind[p] {
            0 => u[p] = 1.0,
            _ => u[0] = 2.0,
        }
    }
}

fn main() {}
