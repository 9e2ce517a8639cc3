//! The loop holds the field.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn sum(grid: &mut Field<Node, _>) {
    for p in grid {
        grid.m[p] = grid.members().m.to_vec()[0];
    }
}

fn main() {}
