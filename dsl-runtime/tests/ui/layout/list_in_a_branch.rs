//! A list in a layout of several branches.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Wrong = layout!(Node: dense(i).place([v]) + dynamic(i, 64).place([m]));

fn main() {}
