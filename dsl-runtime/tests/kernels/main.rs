//! Kernels through the public interface, in several layouts.

mod accumulate;
mod axes;
mod beside;
mod boundaries;
mod captures;
mod enumerations;
mod functions;
mod generic;
mod heads;
mod large;
mod loops;
mod members;
mod mpm;
mod nested;
mod order;
mod panics;
mod parts;
mod random;
mod reductions;
mod slices;
mod spatial;
mod stencils;
mod unchecked;
mod unrolled;

use allotrope::prelude::*;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node {
    v: Vec2,
    m: f32,
}
