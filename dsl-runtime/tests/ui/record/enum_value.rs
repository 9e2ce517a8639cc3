//! The values of variants are literals.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
enum Stage {
    First,
    Last = 3 + 4,
}

fn main() {}
