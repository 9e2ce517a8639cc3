//! A record has 24 members at most.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Lattice {
    f00: f32,
    f01: f32,
    f02: f32,
    f03: f32,
    f04: f32,
    f05: f32,
    f06: f32,
    f07: f32,
    f08: f32,
    f09: f32,
    f10: f32,
    f11: f32,
    f12: f32,
    f13: f32,
    f14: f32,
    f15: f32,
    f16: f32,
    f17: f32,
    f18: f32,
    f19: f32,
    f20: f32,
    f21: f32,
    f22: f32,
    f23: f32,
    f24: f32,
    f25: f32,
    f26: f32,
}

fn main() {}
