//! A record stands for all its members, and a component for its member.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn whole(grid: &mut Field<Node, _>, at: &Field<u32, _>) {
    for p in grid {
        let other = grid[at[p]];
        grid.m[p] = other.m;
    }
}

#[kernel]
fn component(grid: &mut Field<Node, _>) {
    for p in grid {
        grid.v[p].x = grid.v[p + 1].y;
    }
}

fn main() {}
