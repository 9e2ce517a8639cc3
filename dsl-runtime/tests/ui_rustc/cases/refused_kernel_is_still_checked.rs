//! Nothing follows from a refused kernel in its callers, and rustc checks its body beside the macro's errors.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn scatter(nodes: &mut Field<Node, _>, at: &Field<u32, _>, by: f32) -> f32 {
    for p in at {
        nodes.m[at[p]] = by;
        nodes.v[at[p]].x = nodes.m[p + 1];
        nodes.m[0] = nodes.mass[p]; //~ E0609
        nodes.m[p] = by.squared(); //~ E0599
    }
    nodes.m[0]
}

fn main() {
    let (mut nodes, at) = (Field::<Node, Soa>::new([3]), Field::<u32, Aos>::new([3]));
    let total: f32 = scatter(&mut nodes, &at, 2.0);
    assert_eq!(total, 2.0);
}
