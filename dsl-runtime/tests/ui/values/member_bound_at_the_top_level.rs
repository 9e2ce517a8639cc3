//! Members are not bound to variables.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn alias(grid: &mut Field<Node, _>) {
    let masses = grid.m;
}

fn main() {}
