//! A struct is a record, and no element.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
struct Phase {
    code: u8,
}

fn main() {}
