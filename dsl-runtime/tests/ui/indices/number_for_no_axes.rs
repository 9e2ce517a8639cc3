//! A field without axes is indexed by nothing.
use allotrope::prelude::*;

#[kernel]
fn first(one: &mut Field<f32, _, O>) {
    one[0] = 1.0;
}

fn main() {}
