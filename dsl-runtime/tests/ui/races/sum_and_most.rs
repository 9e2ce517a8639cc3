//! One group of operators accumulates into a member.
use allotrope::prelude::*;

#[kernel]
fn mixed(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    for p in keys {
        bins[keys[p]] += 1;
        bins[0].max_assign(keys[p]);
    }
}

fn main() {}
