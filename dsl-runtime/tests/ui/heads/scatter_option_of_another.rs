//! Only `Colored` sorts by a key.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Private, key = keys[p])]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
