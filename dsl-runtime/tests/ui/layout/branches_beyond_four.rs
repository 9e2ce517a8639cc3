//! A layout has four branches at most.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(Node: dense(i).place([v]) + dense(i).place([m]) + dense(i).place([flags]) + dense(i).place([a]) + dense(i).place([b]));

fn main() {}
