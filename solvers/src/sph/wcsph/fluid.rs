//! The constants of a fluid, and the formulas that kernels share.

use allotrope::spatial::*;

use crate::sph::Smoothing;

/// What keeps the fluid off walls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Boundary {
    /// Particles of walls stand for volumes of the fluid at rest (Akinci et al. 2012), and take over the pressure
    /// of the particle beside them, to which the weight of the fluid between is added (Adami et al. 2012, for one particle).
    #[default]
    Volumes,
    /// Particles of walls repel (Monaghan 2005).
    Repulsion,
}

/// A fluid's constants. Quantities a volume are, in 2D, those of a slab one metre thick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluid<X: Spatial> {
    /// The smoothing kernel.
    pub kernel: Smoothing,
    /// Mass of a particle in kg.
    pub mass: f32,
    /// Density at rest in kg/m^3.
    pub density: f32,
    /// The speed of sound at rest in m/s.
    pub sound: f32,
    /// Pressure is `stiffness ((rho / density)^exponent - offset)`: Tait's equation with the exponent 7 and the offset 1,
    /// a gas' with the exponent 1 and the offset 0 or 1 (Becker & Teschner 2007).
    pub exponent: i32,
    /// In Pa: `density sound^2 / exponent`.
    pub stiffness: f32,
    /// See `exponent`.
    pub offset: f32,
    /// Whether pressure may be below zero.
    pub suction: bool,
    /// In m/s^2.
    pub gravity: X::Vec<f32>,
    /// The viscosity's linear factor ..
    pub alpha: f32,
    /// .. and its quadratic one.
    pub beta: f32,
    /// Whether viscosity takes the speed of sound at the density of both particles (Monaghan 1989), not that at rest
    /// (Becker & Teschner 2007).
    pub local_sound: bool,
    /// Surface tension's factor in m^3/(kg s^2), zero for none.
    pub tension: f32,
    /// What keeps it off walls.
    pub boundary: Boundary,
    /// How much more viscous the fluid is beside walls than by itself; zero, if walls slow nothing.
    pub friction: f32,
}

impl<X: Spatial> Fluid<X> {
    /// Pressure in Pa at a density.
    #[inline(always)]
    pub fn pressure(&self, rho: f32) -> f32 {
        let p = self.stiffness * ((rho / self.density).powi(self.exponent) - self.offset);
        if self.suction { p } else { p.max(0.0) }
    }

    /// The speed of sound in m/s at a density: `sound (rho / density)^((exponent - 1) / 2)`.
    #[inline(always)]
    pub fn sound_at(&self, rho: f32) -> f32 {
        self.sound * (rho / self.density).powi(self.exponent - 1).sqrt()
    }

    /// The members `push` and `sound` of a particle of that density.
    #[inline(always)]
    pub(super) fn state(&self, rho: f32) -> (f32, f32) {
        let sound = if self.local_sound { self.sound_at(rho) } else { self.sound };
        (self.pressure(rho) / (rho * rho), sound)
    }

    /// The artificial viscosity of a pair, in m^5/(kg s^2): `approach` is `(v_a - v_b) . (x_a - x_b)`, `sounds` and
    /// `densities` are the sums of both. With `zeta = -h approach / (r^2 + 0.01 h^2)`, where particles approach, it is
    /// `(alpha c zeta + beta zeta^2) / rho` in means of both (Monaghan 1989, and 1992; with `beta`
    /// zero, Becker & Teschner 2007).
    #[inline(always)]
    pub fn viscosity(&self, approach: f32, squared: f32, sounds: f32, densities: f32) -> f32 {
        let h = self.kernel.smoothing_length();
        let softened = squared + 0.01 * h * h;
        // One division for both.
        let inverse = (softened * densities).recip();
        let zeta = -h * approach.min(0.0) * densities * inverse;
        zeta * (self.alpha * sounds + 2.0 * self.beta * zeta) * softened * inverse
    }

    /// A wall particle's repulsion over the distance: times the vector from it, an acceleration in m/s^2 (Monaghan 2005, for a wall particle as heavy as those of the fluid). It ends at two smoothing lengths.
    #[inline(always)]
    pub fn repulsion(&self, squared: f32) -> f32 {
        let h = self.kernel.smoothing_length();
        // Nearer than a hundredth of the smoothing length it does not grow further.
        let squared = squared.max(1e-4 * h * h);
        let q = squared.sqrt() / h;
        let rise = if q <= 2.0 / 3.0 {
            2.0 / 3.0
        } else if q <= 1.0 {
            q * (2.0 - 1.5 * q)
        } else {
            0.5 * (2.0 - q).max(0.0).powi(2)
        };
        0.5 * 0.02 * self.sound * self.sound / squared * rise
    }
}
