//! A layout that names members names no others.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Unknown = layout!(Node: dense(ij).place([v, m], [mass])); //~ E0560

fn main() {}
