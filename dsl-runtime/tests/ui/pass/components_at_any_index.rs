//! Components accumulate at any index, each by itself.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    near: [i32; 2],
}

#[kernel]
fn scatter(at: &Field<u32, _>, grid: &mut Field<Node, _>) {
    for p in at {
        grid.v[at[p]].x += 1.0;
        grid.v[0].y -= 2.0;
        grid.near[at[p]][p as usize % 2] += 1;
    }
}

fn main() {
    let (mut at, mut grid) = (Field::<u32, Soa>::new([4]), Field::<Node, Aos>::new([2]));
    at.set(3, 1);
    scatter(&at, &mut grid);
    assert_eq!((grid.get(0).v, grid.get(1).v), (vec2(3.0, -8.0), vec2(1.0, 0.0)));
    assert_eq!(grid.members().near.to_vec(), [[2, 1], [0, 1]]);
}
