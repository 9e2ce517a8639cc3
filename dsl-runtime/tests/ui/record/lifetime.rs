//! A field owns what it holds.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Spring<'a> {
    rest_length: f32,
    ends: [&'a f32; 2],
}

fn main() {}
