//! A group takes an element as a whole, or apart: `split(v)`.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Wrong = layout!(Node: dense(ij).place([v.x], [m])); //~ E0609

fn main() {}
