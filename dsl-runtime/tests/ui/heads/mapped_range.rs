//! What comes twice would be written twice.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: usize) {
    for i in (0..n).map(|_| 0) {
        u[i] = 1.0;
    }
}

fn main() {}
