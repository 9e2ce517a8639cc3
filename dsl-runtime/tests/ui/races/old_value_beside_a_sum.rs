//! A sum may be put off to the end of the loop, and the old values would not tell of it.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, next: &mut Field<u32, _>, places: &mut Field<u32, _>) {
    for p in keys {
        next[0] += 1;
        places[p] = next[keys[p]].fetch_add(1);
    }
}

fn main() {}
