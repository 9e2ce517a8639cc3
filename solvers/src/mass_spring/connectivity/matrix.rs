//! A table of all pairs of masses.

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::{Connectivity, Vectors};
use crate::mass_spring::records::{Bond, Mass, Rates, Spring};

/// A table of all pairs of masses, in a dense or sparse layout; pairs without a spring have the stiffness zero.
#[derive(Clone, Debug)]
pub struct Matrix<L: Layout<Ij> = Soa> {
    bonds: Field<Bond, L, Ij>,
}

/// A dense table of more masses than this would take gigabytes.
pub(in crate::mass_spring) const MOST_DENSE: usize = 2048;

impl<L: Layout<Ij>> Matrix<L> {
    /// More masses than this are too many for a table in this layout.
    pub const MOST_MASSES: usize = if L::SPARSE { u32::MAX as usize } else { MOST_DENSE };
}

impl<M: Layout<I>, L: Layout<Ij>> Connectivity<M> for Matrix<L> {
    const MOST_MASSES: usize = Self::MOST_MASSES;

    fn new(masses: usize, springs: &[Spring]) -> Result<Self, String> {
        let mut bonds = Field::<Bond, L>::try_new([masses, masses]).map_err(|fault| fault.to_string())?;
        for &Spring { ends: [a, b], bond } in springs {
            bonds.set([a, b], bond);
            bonds.set([b, a], bond);
        }
        Ok(Self { bonds })
    }

    fn add_forces(&self, masses: &mut Field<Mass, M>) {
        add_forces(&self.bonds, masses);
    }

    fn add_resistance(&self, masses: &Field<Mass, M>, p: &Vectors, q: &mut Vectors, rates: Rates) {
        add_resistance(&self.bonds, masses, p, q, rates);
    }

    fn add_diagonal(&self, masses: &Field<Mass, M>, diagonal: &mut Vectors, rates: Rates) {
        add_diagonal(&self.bonds, masses, diagonal, rates);
    }

    fn bytes(&self) -> usize {
        self.bonds.bytes()
    }

    fn memory_map(&self) -> (&'static str, MemoryMap<'_>) {
        ("table of pairs", self.bonds.memory_map())
    }
}

#[kernel]
fn add_forces(bonds: &Field<Bond, _, Ij>, masses: &mut Field<Mass, _>) {
    for (a, b) in bonds {
        if bonds.stiffness[(a, b)] > 0.0 {
            let force = bonds[(a, b)].force(masses.x[a] - masses.x[b], masses.v[a] - masses.v[b]);
            masses.f[a] += force;
        }
    }
}

#[kernel]
fn add_resistance(
    bonds: &Field<Bond, _, Ij>,
    masses: &Field<Mass, _>,
    p: &Field<DVec3, _>,
    q: &mut Field<DVec3, _>,
    rates: Rates,
) {
    for (a, b) in bonds {
        if bonds.stiffness[(a, b)] > 0.0 {
            q[a] += bonds[(a, b)].resistance(masses.x[a] - masses.x[b], p[a] - p[b], rates);
        }
    }
}

#[kernel]
fn add_diagonal(bonds: &Field<Bond, _, Ij>, masses: &Field<Mass, _>, diagonal: &mut Field<DVec3, _>, rates: Rates) {
    for (a, b) in bonds {
        if bonds.stiffness[(a, b)] > 0.0 {
            diagonal[a] += bonds[(a, b)].diagonal(masses.x[a] - masses.x[b], rates);
        }
    }
}
