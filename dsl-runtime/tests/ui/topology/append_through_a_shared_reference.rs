//! `append` changes the field.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, list: &Field<u32, _>) {
    for p in keys {
        list.append((), keys[p]);
    }
}

fn main() {}
