//! One group of operators accumulates into a variable.
use allotrope::prelude::*;

#[kernel]
fn both(u: &Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        total += u[p];
        total *= u[p];
    }
    total
}

fn main() {}
