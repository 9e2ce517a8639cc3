//! One group of operators accumulates into a member.
use allotrope::prelude::*;

#[kernel]
fn extremes(keys: &Field<u32, _>, bins: &mut Field<f32, _>) {
    for p in keys {
        bins[keys[p]].min_assign(1.0);
        bins[keys[p]].max_assign(2.0);
    }
}

fn main() {}
