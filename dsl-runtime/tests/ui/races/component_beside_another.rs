//! A component stands for its member.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn component(grid: &mut Field<Node, _>) {
    for p in grid {
        grid.v[p].x = grid.v[p + 1].y;
    }
}

fn main() {}
