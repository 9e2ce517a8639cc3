//! Reductions are of numbers.
use allotrope::prelude::*;

#[kernel] //~ E0599
fn strings(u: &Field<f32, _>) -> String {
    let mut all = String::new();
    for p in u {
        all += "x"; //~ E0277
        let _ = u[p];
    }
    all
}

fn main() {}
