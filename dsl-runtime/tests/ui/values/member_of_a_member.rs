//! A single member has no members.
use allotrope::prelude::*;

#[kernel]
fn wrong(v: &mut Member<Vec2, _, Ij>) {
    for ij in v {
        v.x[ij] = 1.0;
    }
}

fn main() {}
