//! The elements of a slice have no members to name a branch by.
use allotrope::prelude::*;

#[kernel]
fn clear(list: &mut [Vec2]) {
    for p in list.x {
        list[p] = Vec2::ZERO;
    }
}

fn main() {}
