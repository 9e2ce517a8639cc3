//! Every member stands in a branch.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(Node: dense(ij).place([v]) + dense(ji).place([m])); //~ E0063

fn main() {}
