//! `split` is the one word of groups.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Grid = layout!(Node: dense(ij).place([v, splt(m)]));

fn main() {}
