//! A field without axes has one element.
use allotrope::prelude::*;

#[kernel]
fn running(values: &mut Field<f32, _>, one: &mut Field<f32, _, O>) {
    for p in values {
        one[()] += values[p];
        values[p] = one[()];
    }
}

fn main() {}
