//! The old value of a component cannot be taken.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, pairs: &mut Field<UVec2, _>, places: &mut Field<u32, _>) {
    for p in keys {
        places[p] = pairs[keys[p]].x.fetch_add(1);
    }
}

fn main() {}
