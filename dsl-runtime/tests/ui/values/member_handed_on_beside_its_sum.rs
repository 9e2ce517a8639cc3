//! A function that is handed a member may read all of it, and the loop accumulates into it.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[func]
fn bilinear(q: Read<f32, _>, x: Vec2) -> f32 {
    q[0] * x.x
}

#[kernel]
fn wrong(grid: &mut Field<Node, _>, at: &Field<u32, _>) {
    for p in at {
        grid.m[at[p]] += bilinear(grid.m, grid.v[p]);
    }
}

fn main() {}
