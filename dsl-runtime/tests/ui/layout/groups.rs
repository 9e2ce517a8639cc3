//! Groups are lists of members of a record that the layout names, each member once.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
    a_name_that_is_longer_than_a_type_can_carry: f32,
}

type Nobodys = layout!(dense(ij).place([v], [m]));
type Twice = layout!(Node: dense(ij).place([v, m], [split(m)]));
type NoGroups = layout!(Node: dense(ij).place);
type Empty = layout!(Node: dense(ij).place([v, m], []));
type NoBrackets = layout!(Node: dense(ij).place(v, m));
type NoNames = layout!(Node: dense(ij).place([v.x, 1], [splt(m)]));
type Long = layout!(Node: dense(ij).place([v, m], [a_name_that_is_longer_than_a_type_can_carry]));

fn main() {}
