//! An enum without fields needs no parameters.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
enum Phase<const N: usize> {
    Solid,
    Fluid,
}

fn main() {}
