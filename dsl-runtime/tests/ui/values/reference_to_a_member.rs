//! A member is no reference.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn wrong(grid: &mut Field<Node, _>) {
    for p in grid {
        let v = &grid.v;
        grid.m[p] = v[p].x;
    }
}

fn main() {}
