//! Kernels through the public interface, in several layouts.

mod loops;
mod mpm;
mod stencils;

use allotrope::prelude::*;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub struct Node {
    /// Velocity.
    pub v: Vec2,
    /// Mass.
    pub m: f32,
}
