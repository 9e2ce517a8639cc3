//! A key is found before the loop runs, and changes nothing.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &mut Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Colored, key = { keys[p] += 1; keys[p] })]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
