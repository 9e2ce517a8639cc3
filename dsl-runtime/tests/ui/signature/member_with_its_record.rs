//! A member as a parameter is of any record.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn wrong(u: &Member<'_, Node, Soa, Ij, 1>) {}

fn main() {}
