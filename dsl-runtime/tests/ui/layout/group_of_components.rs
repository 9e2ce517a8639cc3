//! A group holds whole members, or `split` ones.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Grid = layout!(Node: dense(ij).place([v.x, m]));

fn main() {}
