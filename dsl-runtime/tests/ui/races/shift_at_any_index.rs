//! Shifts accumulate nothing.
use allotrope::prelude::*;

#[kernel]
fn shift(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    for p in keys {
        bins[keys[p]] <<= 1;
    }
}

fn main() {}
