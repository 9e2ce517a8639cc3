//! `hash` in a layout of several branches.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Wrong = layout!(Node: dense(ij).place([v]) + hash(ij).dense(ij, 8).place([m]));

fn main() {}
