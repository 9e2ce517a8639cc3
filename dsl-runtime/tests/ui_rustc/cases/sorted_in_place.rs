//! A value read from a field is a copy: changing it in place would be lost (H25).
use allotrope::prelude::*;

#[kernel]
fn sort(near: &mut Field<[i32; 4], _>) {
    for p in near {
        near[p].sort(); //~ E0596
    }
}

fn main() {}
