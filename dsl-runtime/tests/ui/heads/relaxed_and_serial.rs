//! One thread meets no other.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, found: &mut Field<i32, _>) {
    #[serial]
    #[relaxed]
    for p in keys {
        found[keys[p]] = p;
    }
}

fn main() {}
