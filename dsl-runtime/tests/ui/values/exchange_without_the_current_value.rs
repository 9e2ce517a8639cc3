//! `compare_exchange` needs to know what to replace.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, owners: &mut Field<u32, _>, won: &mut Field<bool, _>) {
    for p in keys {
        won[p] = owners[keys[p]].compare_exchange(1).is_ok();
    }
}

fn main() {}
