//! Members and fields are not bound to variables, nor handed on in a parallel loop that changes them.
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
fn wrong(grid: &mut Field<Node, _>, u: &Field<f32, _>) {
    let masses = grid.m;
    for p in grid {
        let v = &grid.v;
        let x = bilinear(grid.m, v[p]);
        let y = bilinear(&u, v[p]);
        grid.m[p] = x + y + grid.m;
    }
}

#[kernel]
fn accumulates(grid: &mut Field<Node, _>, at: &Field<u32, _>) {
    for p in at {
        grid.m[at[p]] += bilinear(grid.m, grid.v[p]);
    }
}

fn main() {}
