//! A member stands in one branch.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(Node: dense(ij).place([v, flags]) + dense(ji).place([m], [v]));

fn main() {}
