//! A loop over a member of a field visits the elements of the member's branch, of which there is one or more.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn grow(grid: &mut Field<Node, _, Ij>) {
    for ij in grid.m {
        grid.m[ij] += 1.0;
        grid.v[ij].x -= 1.0;
    }
}

fn main() {
    let mut rows = Field::<Node, Aos>::new([3, 4]);
    grow(&mut rows);
    let mut two = rows.relayout::<layout!(Node: dense(ji).place([v]) + dense(ij).dense(ij, 2).place([m]))>();
    grow(&mut two);
    assert!(two.iter().all(|node| node.m == 2.0 && node.v.x == -2.0));
}
