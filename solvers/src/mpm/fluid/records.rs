//! What the fluid's particles and the grid's nodes hold.

use allotrope::prelude::*;
use allotrope::spatial::*;

/// A material point.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Point<X: Spatial, T: Real = f32> {
    /// Position in m.
    pub x: X::Vec<T>,
    /// Velocity in m/s.
    pub v: X::Vec<T>,
    /// Gradient of the velocity in 1/s: column `n` is its derivative along axis `n`.
    pub c: X::Mat<T>,
    /// Volume over volume at rest.
    pub j: T,
}

/// A grid node.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Node<X: Spatial, T: Real = f32> {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: X::Vec<T>,
    /// Mass in kg.
    pub m: T,
}
