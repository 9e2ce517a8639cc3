//! What the fluid's particles and grid nodes hold.

use allotrope::prelude::*;

/// A material point of a plane.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Point2 {
    /// Position in m.
    pub x: Vec2,
    /// Velocity in m/s.
    pub v: Vec2,
    /// Gradient of the velocity in 1/s: column `n` is its derivative along axis `n`.
    pub c: Mat2,
    /// Volume over volume at rest.
    pub j: f32,
}

/// A grid node of a plane.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Node2 {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: Vec2,
    /// Mass in kg.
    pub m: f32,
}

/// A material point of space.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Point3 {
    /// Position in m.
    pub x: Vec3,
    /// Velocity in m/s.
    pub v: Vec3,
    /// Gradient of the velocity in 1/s: column `n` is its derivative along axis `n`.
    pub c: Mat3,
    /// Volume over volume at rest.
    pub j: f32,
}

/// A grid node of space.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Node3 {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: Vec3,
    /// Mass in kg.
    pub m: f32,
}
