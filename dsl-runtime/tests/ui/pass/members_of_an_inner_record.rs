//! Members of one inner record are members apart.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[derive(Record, Clone, Copy, Default)]
struct Cell {
    node: Node,
    flag: bool,
}

#[kernel]
fn shift(cells: &mut Field<Cell, _>, at: &Field<u32, _>) {
    for p in at {
        cells.node.v[p] = Vec2::splat(cells.node.m[at[p]]);
        cells.flag[p] = cells.node.m[p] > 1.0;
    }
}

fn main() {
    let (mut cells, mut at) = (Field::<Cell, Soa>::new([4]), Field::<u32, Soa>::new([4]));
    cells.members_mut().node.m.copy_from_slice(&[0.0, 1.0, 2.0, 3.0]);
    at.copy_from_slice(&[3, 2, 1, 0]);
    shift(&mut cells, &at);
    assert_eq!(cells.get(0).node.v, Vec2::splat(3.0));
    assert!(cells.get(3).flag && !cells.get(1).flag);
}
