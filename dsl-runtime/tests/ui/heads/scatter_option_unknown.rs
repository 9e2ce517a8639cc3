//! `Colored` takes a key and a reach, and nothing else.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Colored, tile = 8)]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
