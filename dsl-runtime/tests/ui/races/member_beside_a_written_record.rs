//! A record stands for all its members.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn reset(grid: &mut Field<Node, _>) {
    for p in grid {
        if grid.m[p + 1] > 1.0 {
            grid[p] = Node::default();
        }
    }
}

fn main() {}
