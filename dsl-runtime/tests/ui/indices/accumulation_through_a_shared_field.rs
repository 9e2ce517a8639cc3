//! A field to be written is taken by `&mut`.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &Field<u32, Soa>) {
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
