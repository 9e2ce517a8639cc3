//! A field has no value in a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn show(u: &mut Field<f32, _>) {
    for p in u {
        println!("{u:?}");
        u[p] = 1.0;
    }
}

fn main() {}
