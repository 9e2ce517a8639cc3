//! Members and fields are not bound to variables, nor handed on in a parallel loop.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

fn bilinear(_: f32, x: Vec2) -> f32 {
    x.x
}

#[kernel]
fn wrong(grid: &mut Field<Node, _>, u: &Field<f32, _>) {
    let masses = grid.m;
    for p in grid {
        let v = &grid.v;
        let x = bilinear(grid.m, v[p]);
        let y = bilinear(u, v[p]);
        grid.m[p] = x + y + grid.m;
    }
}

fn main() {}
