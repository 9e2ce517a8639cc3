//! A member that is handed on must be what the function reads, or the function must take one at all.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[func]
fn mean(q: Read<f32, _>, p: i32) -> f32 {
    0.5 * (q[p - 1] + q[p + 1])
}

fn double(x: f32) -> f32 {
    2.0 * x
}

#[kernel]
fn wrong(grid: &Field<Node, _>, plane: &Field<f32, _, Ij>, to: &mut Field<f32, _>) {
    for p in to {
        to[p] = mean(grid.v, p); //~ E0271
        to[p] += mean(grid, p); //~ E0271
        to[p] += mean(plane, p); //~ E0277
        to[p] += mean(to[p], p); //~ E0277
        to[p] += double(grid.m); //~ E0308
    }
}

fn main() {
    mean(vec![1.0, 2.0], 1); //~ E0277
}
