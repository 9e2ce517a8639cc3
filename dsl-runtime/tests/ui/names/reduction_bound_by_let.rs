//! A reduction keeps its name where it is accumulated.
use allotrope::prelude::*;

#[kernel]
fn sum(u: &mut Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        total += u[p];
        let total = 3.0;
        u[p] = total;
    }
    total
}

fn main() {}
