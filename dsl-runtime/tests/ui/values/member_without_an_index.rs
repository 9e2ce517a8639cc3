//! A member has a value for each element.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn double(grid: &mut Field<Node, _>) {
    for p in grid {
        grid.m[p] = 2.0 * grid.m;
    }
}

fn main() {}
