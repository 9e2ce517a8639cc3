//! What particles of the fluid and of walls hold.

use allotrope::prelude::*;
use allotrope::spatial::*;

/// A particle of the fluid. All have the same mass.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Particle<X: Spatial> {
    /// Position in m.
    pub x: X::Vec<f32>,
    /// Velocity in m/s.
    pub v: X::Vec<f32>,
    /// Density in kg/m^3 (in 2D, of a slab one metre thick).
    pub rho: f32,
    /// Pressure over the square of density, in m^5/(kg s^2).
    pub push: f32,
    /// The speed of sound that viscosity takes, in m/s.
    pub sound: f32,
    /// Acceleration in m/s^2.
    pub a: X::Vec<f32>,
}

/// What neighbours read lies together; the acceleration, which they do not, lies apart.
#[cfg(feature = "all-layouts")]
pub(super) type HotParticle<X> = layout!(Particle<X>: dense(i).place([x, v, rho, push, sound], [a]));

/// A particle of a wall, which stays where it is.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct WallParticle<X: Spatial> {
    /// Position in m.
    pub x: X::Vec<f32>,
    /// The volume in m^3 that it stands for (in 2D, m^2).
    pub volume: f32,
}
