//! `place` lists the members of each group.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Grid = layout!(Node: dense(ij).place);

fn main() {}
