//! A field without axes has one element.
use allotrope::prelude::*;

#[kernel]
fn last(values: &Field<f32, _>, one: &mut Field<f32, _, O>) {
    for p in values {
        one[()] = values[p];
    }
}

fn main() {}
