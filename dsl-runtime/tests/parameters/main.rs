//! What kernels take besides whole fields, and what they are generic over. A crate apart from `kernels`, so that both compile at once.

mod functions;
mod generic;
mod members;
// Its notes are kept under a mutex, which the thread sanitizer does not see into: the standard library is not instrumented.
#[cfg(not(allotrope_joined_threads))]
mod nested;
mod slices;
mod spatial;
mod unchecked;

use allotrope::prelude::*;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node {
    v: Vec2,
    m: f32,
}
