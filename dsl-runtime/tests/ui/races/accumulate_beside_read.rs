//! A member that is accumulated into at any index is not read.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn scatter(points: &Field<Node, _>, grid: &mut Field<Node, _>, at: &Field<u32, _>) {
    for p in points {
        grid.m[at[p]] += points.m[p];
        grid.v[at[p]] += points.v[p] / grid.m[at[p]];
    }
}

fn main() {}
