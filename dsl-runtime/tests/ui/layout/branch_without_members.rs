//! A branch says which members it holds.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(Node: dense(ij).place([v, flags]) + dense(ij).dense(ij, 8).aos);

fn main() {}
