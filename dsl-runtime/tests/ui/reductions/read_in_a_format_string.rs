//! A reduction is not read in its loop.
use allotrope::prelude::*;

#[kernel]
fn shown(u: &Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        total += u[p];
        println!("{total}");
    }
    total
}

fn main() {}
