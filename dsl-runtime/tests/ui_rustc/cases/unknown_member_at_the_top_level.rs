//! Members are checked by rustc, at the user's token.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn wrong(grid: &mut Field<Node, _, Ij>) {
    grid.mas[(0, 0)] = 1.0; //~ E0609
}

fn main() {}
