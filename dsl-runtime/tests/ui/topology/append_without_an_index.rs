//! The index of the list comes first.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, list: &mut Field<u32, _>) {
    for p in keys {
        list.append(keys[p]);
    }
}

fn main() {}
