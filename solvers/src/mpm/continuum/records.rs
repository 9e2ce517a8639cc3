//! What particles and nodes hold.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::Dimensions;
pub use crate::mpm::fluid::Node;

/// A particle that carries an affine velocity field.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct AffinePoint<X: Spatial> {
    /// Position in m.
    pub x: X::Vec<f32>,
    /// Velocity in m/s.
    pub v: X::Vec<f32>,
    /// Gradient of the velocity in 1/s.
    pub c: X::Mat<f32>,
    /// Kirchhoff stress in Pa.
    pub stress: X::Mat<f32>,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: X::Mat<f32>,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A particle that carries a velocity.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct PlainPoint<X: Spatial> {
    /// Position in m.
    pub x: X::Vec<f32>,
    /// Velocity in m/s.
    pub v: X::Vec<f32>,
    /// Kirchhoff stress in Pa.
    pub stress: X::Mat<f32>,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: X::Mat<f32>,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A particle that carries a polynomial velocity field.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct PolynomialPoint<X: Dimensions> {
    /// Position in m.
    pub x: X::Vec<f32>,
    /// Coefficients of the velocity in m/s, the first of which is the velocity; lengths are in cells.
    pub modes: X::Modes,
    /// Kirchhoff stress in Pa.
    pub stress: X::Mat<f32>,
    /// Mass in kg.
    pub mass: f32,
    /// The elastic part of the deformation gradient.
    pub deformation_gradient: X::Mat<f32>,
    /// What the material remembers of its plastic flow.
    pub plastic: Vec2,
    /// Which of the scene's materials it is of.
    pub material: u32,
}

/// A grid node that remembers how fast it was.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct ChangingNode<X: Spatial> {
    /// Momentum in kg m/s; from the grid update on, velocity in m/s.
    pub v: X::Vec<f32>,
    /// From the scatter on, momentum without forces; from the grid update on, that velocity.
    pub before: X::Vec<f32>,
    /// Mass in kg.
    pub m: f32,
}

/// What both transfers touch lies together; what the material alone needs lies apart.
pub(in crate::mpm) type HotAffine<X> =
    layout!(AffinePoint<X>: dense(i).place([x, v, c, stress, mass, deformation_gradient], [plastic, material]));

/// As [`HotAffine`].
pub(in crate::mpm) type HotPlain<X> =
    layout!(PlainPoint<X>: dense(i).place([x, v, stress, mass, deformation_gradient], [plastic, material]));

/// As [`HotAffine`].
pub(in crate::mpm) type HotPolynomial<X> =
    layout!(PolynomialPoint<X>: dense(i).place([x, modes, stress, mass, deformation_gradient], [plastic, material]));
