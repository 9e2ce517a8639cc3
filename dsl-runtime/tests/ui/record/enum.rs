//! A record has the same members in every element.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
enum Material {
    Fluid { density: f32 },
    Solid { stiffness: f32 },
}

fn main() {}
