//! How time runs, and what acts on masses beside springs.

use allotrope::prelude::*;

use super::records::Rates;
use crate::linear::Stop;

/// How a step of `dt` is made from force `f`, velocity `v` and position `x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Integrator {
    /// `x' = x + dt v`, `v' = v + dt f(x) / m`. Never stable for springs without damping: the energy of an oscillation
    /// of angular frequency `w` grows by `1 + (w dt)^2` a step.
    ForwardEuler,
    /// `v' = v + dt f(x) / m`, `x' = x + dt v'`. Stable for `w dt < 2`.
    SymplecticEuler,
    /// The same with the force at `x + beta dt v'`, linearised at `x`; `beta` is above 0 and at most 1:
    /// `[M - beta dt^2 df/dx] v' = M v + dt f(x)`. One is backward Euler; one half is of first order, too, and
    /// dissipates.
    Beta(f64),
    /// The force at the mean of old and new position, linearised at `x`, and `x' = x + dt (v + v') / 2`:
    /// `[M - dt^2 / 4 df/dx] v' = M v + dt f(x) + dt^2 / 4 df/dx v`. Of second order; keeps the energy of linear springs.
    ImplicitMidpoint,
}

impl Integrator {
    /// Whether a step needs no system of equations.
    pub fn is_explicit(self) -> bool {
        matches!(self, Self::ForwardEuler | Self::SymplecticEuler)
    }

    /// The factors of derivatives of the force in the matrix, the factor of `df/dx v` on the right-hand side of the
    /// system for `v' - v`, and which part of the new velocity the step moves with. Dashpots are taken at the same mean
    /// of old and new velocity as springs at that of positions.
    pub(super) fn implicit(self, dt: f64) -> Implicit {
        let rates = |stiffness, damping| Rates { stiffness, damping };
        match self {
            Self::ForwardEuler => Implicit { matrix: rates(0.0, 0.0), right: 0.0, new: 0.0 },
            Self::SymplecticEuler => Implicit { matrix: rates(0.0, 0.0), right: 0.0, new: 1.0 },
            Self::Beta(beta) => Implicit { matrix: rates(beta * dt * dt, beta * dt), right: beta * dt * dt, new: 1.0 },
            Self::ImplicitMidpoint => {
                Implicit { matrix: rates(0.25 * dt * dt, 0.5 * dt), right: 0.5 * dt * dt, new: 0.5 }
            }
        }
    }
}

/// What [`Integrator::implicit`] tells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Implicit {
    pub(super) matrix: Rates,
    pub(super) right: f64,
    pub(super) new: f64,
}

/// By what the systems of implicit steps are solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Conjugate gradients.
    ConjugateGradients,
    /// Jacobi's iteration, with this damping (1: none).
    Jacobi(f64),
}

/// A place that pulls all masses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attractor {
    /// In m.
    pub place: DVec3,
    /// Acceleration a distance in 1/s^2; zero: none.
    pub strength: f64,
}

/// How time runs, and what acts on masses beside springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Seconds a step.
    pub dt: f64,
    /// How a step is made.
    pub integrator: Integrator,
    /// By what the systems of implicit steps are solved ..
    pub method: Method,
    /// .. and how far.
    pub stop: Stop,
    /// m/s^2.
    pub gravity: DVec3,
    /// After each step velocities are multiplied by `exp(-dt drag)`, in 1/s.
    pub drag: f64,
    /// A place that pulls all masses.
    pub attractor: Attractor,
    /// The corners of the box that masses cannot leave: a wall stops what goes through it.
    pub walls: [DVec3; 2],
    /// Whether steps beyond the bound of an explicit integrator are taken all the same.
    pub unstable: bool,
}

impl Default for Parameters {
    /// Steps of 1 ms of symplectic Euler, with nothing but springs.
    fn default() -> Self {
        Self {
            dt: 1e-3,
            integrator: Integrator::SymplecticEuler,
            method: Method::ConjugateGradients,
            // The matrix is symmetric by its making.
            stop: Stop { check_symmetry: false, most: 10_000, ..Stop::at(1e-10) },
            gravity: DVec3::ZERO,
            drag: 0.0,
            attractor: Attractor::default(),
            walls: [DVec3::NEG_INFINITY, DVec3::INFINITY],
            unstable: false,
        }
    }
}
