//! A member is not both written and accumulated into at any index.
use allotrope::prelude::*;

#[kernel]
fn clear_and_add(bins: &mut Field<u32, _>, keys: &Field<u32, _>) {
    for p in bins {
        bins[p] = 0;
        bins[keys[p]] += 1;
    }
}

fn main() {}
