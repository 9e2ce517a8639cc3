//! Kernels through the public interface, in several layouts. Under the sanitizers, which compile slowly, those modules that reach memory in
//! ways of their own; under the thread sanitizer, those in which threads meet in ways of their own.

mod accumulate;
#[cfg(not(allotrope_sanitized))]
mod axes;
mod beside;
#[cfg(not(allotrope_sanitized))]
mod boundaries;
#[cfg(not(allotrope_joined_threads))]
mod branches;
#[cfg(not(allotrope_sanitized))]
mod captures;
mod colored;
#[cfg(not(allotrope_sanitized))]
mod enumerations;
#[cfg(not(allotrope_sanitized))]
mod heads;
// A sanitizer keeps account of all memory, touched or not.
#[cfg(not(allotrope_sanitized))]
mod large;
#[cfg(not(allotrope_sanitized))]
mod linear;
mod loops;
#[cfg(not(allotrope_sanitized))]
mod nested_records;
#[cfg(not(allotrope_sanitized))]
mod order;
#[cfg(not(allotrope_joined_threads))]
mod origin;
#[cfg(not(allotrope_joined_threads))]
mod panics;
#[cfg(not(allotrope_sanitized))]
mod parts;
#[cfg(not(allotrope_sanitized))]
mod random;
mod reductions;
#[cfg(not(allotrope_sanitized))]
mod stencils;
mod together;
#[cfg(not(allotrope_joined_threads))]
mod unrolled;

use allotrope::prelude::*;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node {
    v: Vec2,
    m: f32,
}
