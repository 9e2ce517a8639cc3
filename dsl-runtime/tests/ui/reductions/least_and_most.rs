//! One group of operators accumulates into a variable.
use allotrope::prelude::*;

#[kernel]
fn both(u: &Field<f32, _>) -> f32 {
    let mut extreme = 0.0f32;
    for p in u {
        extreme.min_assign(u[p]);
        extreme.max_assign(u[p]);
    }
    extreme
}

fn main() {}
