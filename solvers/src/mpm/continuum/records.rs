//! What particles and nodes hold.

use allotrope::prelude::*;

use super::{Matrix, Modes, Vector};

/// A particle that carries an affine velocity field.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct AffinePoint {
    /// Position in m.
    pub x: Vector,
    /// Velocity in m/s.
    pub v: Vector,
    /// Gradient of the velocity in 1/s.
    pub c: Matrix,
    /// Kirchhoff stress in Pa.
    pub stress: Matrix,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: Matrix,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A particle that carries a velocity.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct PlainPoint {
    /// Position in m.
    pub x: Vector,
    /// Velocity in m/s.
    pub v: Vector,
    /// Kirchhoff stress in Pa.
    pub stress: Matrix,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: Matrix,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A particle that carries a polynomial velocity field.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct PolynomialPoint {
    /// Position in m.
    pub x: Vector,
    /// Coefficients of the velocity in m/s, the first of which is the velocity; lengths are in cells.
    pub modes: Modes,
    /// Kirchhoff stress in Pa.
    pub stress: Matrix,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: Matrix,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A grid node.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: Vector,
    /// Mass in kg.
    pub m: f32,
}

/// A grid node that remembers how fast it was.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct ChangingNode {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: Vector,
    /// From the scatter on, momentum without forces; from the grid update on, that velocity.
    pub before: Vector,
    /// Mass in kg.
    pub m: f32,
}

/// What both transfers touch lies together; what the material alone needs lies apart.
pub(in crate::mpm) type HotAffine =
    layout!(AffinePoint: dense(i).place([x, v, c, stress, mass, deformation_gradient], [plastic, material]));

/// As [`HotAffine`].
pub(in crate::mpm) type HotPlain =
    layout!(PlainPoint: dense(i).place([x, v, stress, mass, deformation_gradient], [plastic, material]));

/// As [`HotAffine`].
pub(in crate::mpm) type HotPolynomial =
    layout!(PolynomialPoint: dense(i).place([x, modes, stress, mass, deformation_gradient], [plastic, material]));
