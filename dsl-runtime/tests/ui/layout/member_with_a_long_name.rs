//! A layout carries short names.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    a_name_that_is_longer_than_a_type_can_carry: f32,
}

type Grid = layout!(Node: dense(ij).place([a_name_that_is_longer_than_a_type_can_carry]));

fn main() {}
