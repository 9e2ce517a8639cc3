//! The elements of a slice have no members.
use allotrope::prelude::*;

#[kernel]
fn wrong(list: &mut [Vec2]) {
    for i in list {
        list.x[i] = 1.0;
    }
}

fn main() {}
