//! Kernels through the public interface, in several layouts.

mod accumulate;
mod axes;
mod beside;
mod boundaries;
mod branches;
mod captures;
mod enumerations;
mod heads;
// A sanitizer keeps account of all memory, touched or not.
#[cfg(not(allotrope_sanitized))]
mod large;
mod linear;
mod loops;
mod mpm;
mod nested_records;
mod order;
mod origin;
mod panics;
mod parts;
mod random;
mod reductions;
mod stencils;
mod together;
mod unrolled;

use allotrope::prelude::*;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node {
    v: Vec2,
    m: f32,
}
