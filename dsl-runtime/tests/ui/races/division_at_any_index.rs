//! Division accumulates nothing.
use allotrope::prelude::*;

#[kernel]
fn divide(keys: &Field<u32, _>, bins: &mut Field<f32, _>) {
    for p in keys {
        bins[keys[p]] /= 2.0;
    }
}

fn main() {}
