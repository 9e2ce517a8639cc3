//! An index has as many places as its field has axes.
use allotrope::prelude::*;

#[kernel]
fn first(v: &mut Field<f32, _, Ij>) {
    v[0] = 1.0;
}

fn main() {}
