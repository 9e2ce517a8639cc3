//! Branches name members, and whose they are.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    flags: u8,
}

type Wrong = layout!(dense(ij).place([v, flags]) + dense(ji).place([m]));

fn main() {}
