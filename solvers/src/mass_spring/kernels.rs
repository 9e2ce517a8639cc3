//! What happens to each mass by itself.

use allotrope::prelude::*;

use super::parameters::{Attractor, Parameters};
use super::records::Mass;

/// What moves a mass, with the constants of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    dt: f64,
    gravity: DVec3,
    attractor: Attractor,
    /// What drag leaves of a velocity.
    decay: f64,
    walls: [DVec3; 2],
    /// Which parts of the old and the new velocity move masses.
    old: f64,
    new: f64,
}

impl Motion {
    pub(super) fn new(parameters: &Parameters) -> Self {
        let Parameters { dt, integrator, gravity, drag, attractor, walls, .. } = *parameters;
        let new = integrator.implicit(dt).new;
        Self { dt, gravity, attractor, decay: (-dt * drag).exp(), walls, old: 1.0 - new, new }
    }

    /// The acceleration by all but springs.
    #[inline(always)]
    fn acceleration(&self, x: DVec3) -> DVec3 {
        self.gravity - (x - self.attractor.place) * self.attractor.strength
    }

    /// Position and velocity after a step that changes the velocity so. A wall stops what goes through it, along its
    /// normal.
    #[inline(always)]
    fn after(&self, x: DVec3, v: DVec3, change: DVec3) -> (DVec3, DVec3) {
        let slowed = (v + change) * self.decay;
        let free = x + (v * self.old + slowed * self.new) * self.dt;
        let [low, high] = self.walls;
        let x = free.clamp(low, high);
        (x, DVec3::select(free.cmpeq(x), slowed, DVec3::ZERO))
    }
}

/// A step of an explicit integrator with the forces that are there, which are then zero. Returns how many masses are not
/// finite.
#[kernel]
pub(super) fn advance(masses: &mut Field<Mass, _>, motion: &Motion) -> u32 {
    let mut broken = 0;
    for m in masses {
        if !masses.fixed[m] {
            let x = masses.x[m];
            let acceleration = masses.f[m] * (1.0 / masses.mass[m]) + motion.acceleration(x);
            let (x, v) = motion.after(x, masses.v[m], acceleration * motion.dt);
            masses.x[m] = x;
            masses.v[m] = v;
            broken += u32::from(!(x + v).is_finite());
        }
        masses.f[m] = DVec3::ZERO;
    }
    broken
}

/// A step that changes velocities so.
#[kernel]
pub(super) fn advance_by(masses: &mut Field<Mass, _>, change: &Field<DVec3, _>, motion: &Motion) -> u32 {
    let mut broken = 0;
    for m in masses {
        if !masses.fixed[m] {
            let (x, v) = motion.after(masses.x[m], masses.v[m], change[m]);
            masses.x[m] = x;
            masses.v[m] = v;
            broken += u32::from(!(x + v).is_finite());
        }
    }
    broken
}

/// Velocities, as a vector.
#[kernel]
pub(super) fn velocities(masses: &Field<Mass, _>, p: &mut Field<DVec3, _>) {
    for m in p {
        p[m] = masses.v[m];
    }
}

/// The right-hand side of the system for the change of velocity, `dt f + right df/dx v`, from the forces that are there,
/// which are then zero, and from what springs resist `right v` with. Fixed masses keep their velocity.
#[kernel]
pub(super) fn right_hand_side(
    masses: &mut Field<Mass, _>,
    resisted: &Field<DVec3, _>,
    b: &mut Field<DVec3, _>,
    right: f64,
    motion: &Motion,
) {
    for m in masses {
        let mass = masses.mass[m];
        let force = masses.f[m] + motion.acceleration(masses.x[m]) * mass;
        let pulled = masses.v[m] * (right * motion.attractor.strength * mass);
        b[m] = if masses.fixed[m] { DVec3::ZERO } else { force * motion.dt - resisted[m] - pulled };
        masses.f[m] = DVec3::ZERO;
    }
}

/// `q <- M p + q`, the attractor's part of the matrix among `M`, or `M p` for fixed masses; returns `p . q`.
#[kernel]
pub(super) fn add_inertia(masses: &Field<Mass, _>, p: &Field<DVec3, _>, q: &mut Field<DVec3, _>, pull: f64) -> f64 {
    let mut curvature = 0.0;
    for m in q {
        let (own, mass) = (p[m], masses.mass[m]);
        let product = if masses.fixed[m] { own * mass } else { own * (mass * (1.0 + pull)) + q[m] };
        q[m] = product;
        curvature += own.dot(product);
    }
    curvature
}

/// The same for the diagonal.
#[kernel]
pub(super) fn add_inertia_to_diagonal(masses: &Field<Mass, _>, diagonal: &mut Field<DVec3, _>, pull: f64) {
    for m in diagonal {
        let mass = DVec3::splat(masses.mass[m]);
        diagonal[m] = if masses.fixed[m] { mass } else { mass * (1.0 + pull) + diagonal[m] };
    }
}

/// Makes a vector zero.
#[kernel]
pub(super) fn clear(q: &mut Field<DVec3, _>) {
    for m in q {
        q[m] = DVec3::ZERO;
    }
}
