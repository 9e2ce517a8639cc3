//! A component is accumulated into at the own index alone.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn scattered_component(grid: &mut Field<Node, _>, at: &Field<u32, _>) {
    for p in at {
        grid.v[at[p]].x += 1.0;
    }
}

fn main() {}
