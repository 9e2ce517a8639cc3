//! What is read beside old values that are taken depends on the threads.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, next: &mut Field<u32, _>, places: &mut Field<u32, _>) {
    for p in keys {
        places[p] = next[keys[p]].fetch_add(1);
        if next[keys[p]] > 8 {
            places[p] = 0;
        }
    }
}

fn main() {}
