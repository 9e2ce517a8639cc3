//! A reduction cannot be seen before the loop has ended (H11).
use allotrope::prelude::*;

#[kernel]
fn sum(u: &Field<f32, _>) -> f32 {
    let mut total = 0.0;
    let seen = || total;
    for p in u {
        total += u[p] * seen(); //~ E0502
    }
    total
}

fn main() {}
