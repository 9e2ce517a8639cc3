//! A record stands for all its members.
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

fn main() {}
