//! What masses and springs hold.

use allotrope::prelude::*;

/// A point mass.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Mass {
    /// Position in m.
    pub x: DVec3,
    /// Velocity in m/s.
    pub v: DVec3,
    /// The force of its springs in N, zero between steps.
    pub f: DVec3,
    /// In kg, above zero.
    pub mass: f64,
    /// Whether it is held in its place.
    pub fixed: bool,
}

/// What a spring is, whatever it joins.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Bond {
    /// `k` in N/m, above zero. (A spring given by a force `Y` a relative stretch, as some programs have it, has
    /// `k = Y / rest`.)
    pub stiffness: f64,
    /// Length at rest in m.
    pub rest: f64,
    /// Force along the spring a relative speed of its ends, in N s/m.
    pub dashpot: f64,
}

/// A spring, and the masses that it joins.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Spring {
    /// The numbers of two masses.
    pub ends: [u32; 2],
    /// What joins them.
    pub bond: Bond,
}

/// A spring as one of its masses sees it.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub struct Link {
    /// The mass at the other end.
    pub other: u32,
    /// What joins them.
    pub bond: Bond,
}

/// Factors of the two derivatives of a spring's force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// Of that by position, in s^2.
    pub stiffness: f64,
    /// Of that by velocity, in s.
    pub damping: f64,
}

impl Bond {
    /// The force in N on the first of two masses, `d` and `u` from the second to it in position and velocity: Hooke's
    /// `-k (|d| - rest) d / |d|` and the dashpot along the spring. Two masses in one place pull in no direction.
    #[inline(always)]
    pub fn force(self, d: DVec3, u: DVec3) -> DVec3 {
        let length = d.length();
        if length == 0.0 {
            return DVec3::ZERO;
        }
        let n = d * (1.0 / length);
        n * -(self.stiffness * (length - self.rest) + self.dashpot * u.dot(n))
    }

    /// Minus the change of [`force`](Self::force) with the change `e` of `d`, and of `u`, each times its rate:
    /// `k ((1 - rest / |d|) (e - n n.e) + n n.e)` and `dashpot n n.e` (Baraff & Witkin 1998, "Large steps in cloth
    /// simulation"). A compressed spring gives way sidewards, which would make the matrix indefinite: there the first
    /// term is left out (Choi & Ko 2002, "Stable but responsive cloth").
    #[inline(always)]
    pub fn resistance(self, d: DVec3, e: DVec3, rates: Rates) -> DVec3 {
        let (sideward, along, n) = self.stiffnesses(d, rates);
        let axial = n * n.dot(e);
        (e - axial) * sideward + axial * along
    }

    /// The diagonal of the matrix of [`resistance`](Self::resistance).
    #[inline(always)]
    pub fn diagonal(self, d: DVec3, rates: Rates) -> DVec3 {
        let (sideward, along, n) = self.stiffnesses(d, rates);
        DVec3::splat(sideward) + n * n * (along - sideward)
    }

    /// Across the spring, along it, and its direction.
    #[inline(always)]
    fn stiffnesses(self, d: DVec3, rates: Rates) -> (f64, f64, DVec3) {
        let length = d.length();
        if length == 0.0 {
            return (0.0, 0.0, DVec3::ZERO);
        }
        let inverse = 1.0 / length;
        let sideward = rates.stiffness * self.stiffness * (1.0 - self.rest * inverse).max(0.0);
        let along = rates.stiffness * self.stiffness + rates.damping * self.dashpot;
        (sideward, along, d * inverse)
    }
}
