//! A record has all of its members at once.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
union Bits {
    float: f32,
    bits: u32,
}

fn main() {}
