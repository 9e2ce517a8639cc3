//! A parallel loop runs over a field.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn clear(grid: &mut Field<Node, _>) {
    for p in grid.m {
        grid.m[p] = 0.0;
    }
}

fn main() {}
