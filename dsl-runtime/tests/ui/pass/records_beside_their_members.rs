//! A whole record and its members mix at the own index.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn reset(grid: &mut Field<Node, _>, other: &Field<Node, _>) {
    for p in grid {
        let node = grid[p];
        grid.m[p] = node.m + 1.0;
        let v = other.v[p];
        grid[p] = Node { v, ..grid[p] };
        grid.v[p].x += other[p].m;
        let Node { v: Vec2 { x, .. }, m } = grid[p];
        grid.m[p] = m + x;
    }
}

fn main() {
    let (mut grid, mut other) = (Field::<Node, Aos>::new([2]), Field::<Node, Split>::new([2]));
    other.fill(Node { v: vec2(5.0, 6.0), m: 10.0 });
    reset(&mut grid, &other);
    assert_eq!(grid.get(1).v, vec2(15.0, 6.0));
    assert_eq!(grid.get(1).m, 16.0);
}
