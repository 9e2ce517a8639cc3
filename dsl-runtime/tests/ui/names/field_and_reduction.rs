//! Fields and reductions keep their names.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        total += u[p];
        let total = 3.0;
        u[p] = total;
    }
    let u = 3;
    total
}

fn main() {}
