//! A member to write is a `&mut Member`.
use allotrope::MemberMut;
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn wrong(u: &mut MemberMut<'_, Node, Soa, Ij, 1>) {}

fn main() {}
