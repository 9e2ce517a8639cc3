//! An enum that is an element has no values beside its variant.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
enum Material {
    Fluid,
    Solid { stiffness: f32 },
}

fn main() {}
