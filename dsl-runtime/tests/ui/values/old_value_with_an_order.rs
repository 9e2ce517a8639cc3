//! Elements are no atomic variables with orders of memory.
use std::sync::atomic::Ordering;

use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, next: &mut Field<u32, _>, places: &mut Field<u32, _>) {
    for p in keys {
        places[p] = next[keys[p]].fetch_add(1, Ordering::Relaxed);
    }
}

fn main() {}
