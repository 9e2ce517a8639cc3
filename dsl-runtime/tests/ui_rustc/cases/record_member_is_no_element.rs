//! What a field cannot hold is an error at the member's type.
use allotrope::prelude::*;

#[derive(Clone, Copy)]
struct Handle(u32);

type Text = &'static str;

#[derive(Record, Clone, Copy)]
struct Mixed {
    v: Vec2,
    name: Text, //~ E0277
    wide: [u128; 4], //~ E0277
    handle: Handle, //~ E0277
}

fn main() {}
