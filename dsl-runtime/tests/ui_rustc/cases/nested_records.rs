//! Members of a record in a record are its own.
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
fn wrong(cells: &mut Field<Cell, _>) {
    for p in cells {
        cells.node.mass[p] = 1.0; //~ E0609
        cells.flag.m[p] = 1.0; //~ E0609
    }
}

fn main() {
    let cells = Field::<Cell, Soa>::new([3]);
    let _ = cells.members().node.x.to_vec(); //~ E0609
}
