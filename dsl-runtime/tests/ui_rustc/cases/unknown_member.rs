//! Members are checked by rustc, at the user's token.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn wrong(grid: &mut Field<Node, _, Ij>) {
    for ij in grid {
        grid.mass[ij] = 1.0; //~ E0609
        grid.m[ij] = 2.0;
    }
}

fn main() {}
