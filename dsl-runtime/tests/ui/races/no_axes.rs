//! A field without axes has one element, which every iteration of a loop over anything else would write.
use allotrope::prelude::*;

#[kernel]
fn last(values: &Field<f32, _>, one: &mut Field<f32, _, O>) {
    for p in values {
        one[()] = values[p];
    }
}

#[kernel]
fn running(values: &mut Field<f32, _>, one: &mut Field<f32, _, O>) {
    for p in values {
        one[()] += values[p];
        values[p] = one[()];
    }
}

#[kernel]
fn count(one: &mut Field<f32, _, O>, n: usize) {
    for i in 0..n {
        one[i] = 1.0;
    }
}

fn main() {}
