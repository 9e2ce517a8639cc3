//! A new field holds zeros, which must be a variant.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
enum Wall {
    Sticky = 1,
    Slippery,
}

fn main() {}
