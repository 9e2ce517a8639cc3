//! A captured or reduced name stands alone in a struct's literal.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn set(grid: &mut Field<Node, _>, v: Vec2, m: &f32) {
    let all = vec![v; 2];
    for p in grid {
        let m = *m + p as f32;
        let v = all[p as usize];
        grid[p] = Node { v, m };
    }
    let v = 2.0 * v;
    for p in grid {
        grid[p] = Node { v, ..Default::default() };
    }
}

fn main() {
    let mut grid = Field::<Node, Soa>::new([2]);
    set(&mut grid, vec2(1.0, 2.0), &3.0);
    assert_eq!(grid.get(1).v, vec2(2.0, 4.0));
}
