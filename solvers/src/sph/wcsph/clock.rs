//! How long a step may be.

use allotrope::spatial::*;

use super::Fluid;

/// The bounds of a step, in s: what each of them is now, and what was taken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimeStep {
    /// `0.25 sqrt(h / |a|)` of the strongest acceleration.
    pub force: f64,
    /// `0.4 h / (c (1 + 0.6 alpha))` of the fastest sound.
    pub sound: f64,
    /// `0.4 h / |v|` of the fastest particle.
    pub speed: f64,
    /// The step.
    pub dt: f64,
}

/// The largest of what bounds a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extremes {
    /// The square of the strongest acceleration, in m^2/s^4.
    pub acceleration_squared: f32,
    /// The square of the fastest particle's speed, in m^2/s^2.
    pub speed_squared: f32,
    /// The highest density in kg/m^3.
    pub density: f32,
}

impl TimeStep {
    /// The step that a fluid bears, and `most` at most (Monaghan 1992; Becker & Teschner 2007). The
    /// speed of sound is that at the highest density, `c (rho / density)^((exponent - 1) / 2)`.
    pub fn new<X: Spatial>(fluid: &Fluid<X>, extremes: &Extremes, most: f64) -> Self {
        let h = f64::from(fluid.kernel.smoothing_length());
        let fastest = f64::from(fluid.sound_at(extremes.density.max(fluid.density)));
        let force = 0.25 * (h / f64::from(extremes.acceleration_squared).sqrt()).sqrt();
        let sound = 0.4 * h / (fastest * (1.0 + 0.6 * f64::from(fluid.alpha)));
        let speed = 0.4 * h / f64::from(extremes.speed_squared).sqrt();
        Self { force, sound, speed, dt: force.min(sound).min(speed).min(most) }
    }
}
