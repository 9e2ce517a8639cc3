//! A field keeps its name.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    let u = 3;
}

fn main() {}
