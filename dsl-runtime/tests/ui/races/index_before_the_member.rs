//! `grid[q].m` reads the whole record.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn other_member(grid: &mut Field<Node, _>) {
    for p in grid {
        grid.m[p] = grid[p + 1].v.x;
    }
}

fn main() {}
