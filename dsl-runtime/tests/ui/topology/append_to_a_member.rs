//! The entries of lists are whole records.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, list: &mut Field<Vec2, _>) {
    for p in keys {
        list.x.append((), 1.0);
    }
}

fn main() {}
