//! Records are values that move by components.
use allotrope::prelude::*;

#[derive(Record, Clone)]
struct Node { //~ E0277
    v: Vec2,
}

fn main() {}
