//! A layout that names members names each of its record's.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Missing = layout!(Node: dense(ij).place([v])); //~ E0063

fn main() {}
