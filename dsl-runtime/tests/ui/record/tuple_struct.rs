//! Kernels name members.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Pair(Vec2, f32);

fn main() {}
