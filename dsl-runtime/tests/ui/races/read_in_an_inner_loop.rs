//! Inner loops are looked into.
use allotrope::prelude::*;

#[kernel]
fn pull(u: &mut Field<f32, _>) {
    for p in u {
        for q in u {
            u[p] += u[q];
        }
    }
}

fn main() {}
