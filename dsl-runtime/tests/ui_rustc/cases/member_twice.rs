//! The borrow checker keeps one member from being handed in twice, and members from outliving their field.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: f32,
    m: f32,
}

#[kernel]
fn both(a: &mut Member<f32, _, Ij>, b: &mut Member<f32, _, Ij>) {
    for ij in a {
        a[ij] = b[ij];
    }
}

fn main() {
    let mut grid = Field::<Node, Soa>::new([4, 4]);
    let mut members = grid.members_mut();
    both(&mut members.m, &mut members.v);
    both(&mut members.m, &mut members.m); //~ E0499
    grid.fill(Node::default()); //~ E0499
    both(&mut members.m, &mut members.v);
}
