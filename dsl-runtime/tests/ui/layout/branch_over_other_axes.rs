//! All members of a field have the same axes.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(Node: dense(ij).place([v, flags]) + dense(i).place([m]));

fn main() {}
