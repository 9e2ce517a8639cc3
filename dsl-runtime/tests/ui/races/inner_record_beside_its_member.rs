//! A record in a record is written with all of its members.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[derive(Record, Clone, Copy)]
struct Cell {
    node: Node,
    flag: bool,
}

#[kernel]
fn wrong(cells: &mut Field<Cell, _>, at: &Field<u32, _>, nodes: &Field<Node, _>) {
    for p in cells {
        cells.flag[p] = cells.node.m[at[p]] > 1.0;
        cells.node[p] = nodes[p];
    }
}

fn main() {}
