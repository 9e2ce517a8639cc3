//! One group of operators accumulates into a member.
use allotrope::prelude::*;

#[kernel]
fn mixed(keys: &Field<u32, _>, bins: &mut Field<f32, _>) {
    for p in keys {
        bins[keys[p]] += 1.0;
        bins[keys[p]] *= 2.0;
    }
}

fn main() {}
