//! One group of operators accumulates into a member.
use allotrope::prelude::*;

#[kernel]
fn flags(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    for p in keys {
        bins[keys[p]] |= 1;
        bins[keys[p]] &= 6;
    }
}

fn main() {}
