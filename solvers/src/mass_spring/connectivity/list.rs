//! One list of all springs.

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::{Connectivity, Vectors};
use crate::mass_spring::records::{Mass, Rates, Spring};

/// One list of all springs, in the layout `L`; each adds to both of its masses.
#[derive(Clone, Debug)]
pub struct List<L: Layout<I> = Aos> {
    springs: Field<Spring, L>,
}

impl<M: Layout<I>, L: Layout<I>> Connectivity<M> for List<L> {
    fn new(_masses: usize, springs: &[Spring]) -> Result<Self, String> {
        let mut list = Field::<Spring, L>::try_new([springs.len()]).map_err(|fault| fault.to_string())?;
        springs.iter().enumerate().for_each(|(n, &spring)| list.set(n, spring));
        Ok(Self { springs: list })
    }

    fn add_forces(&self, masses: &mut Field<Mass, M>) {
        add_forces(&self.springs, masses);
    }

    fn add_resistance(&self, masses: &Field<Mass, M>, p: &Vectors, q: &mut Vectors, rates: Rates) {
        add_resistance(&self.springs, masses, p, q, rates);
    }

    fn add_diagonal(&self, masses: &Field<Mass, M>, diagonal: &mut Vectors, rates: Rates) {
        add_diagonal(&self.springs, masses, diagonal, rates);
    }

    fn bytes(&self) -> usize {
        self.springs.bytes()
    }

    fn memory_map(&self) -> (&'static str, MemoryMap<'_>) {
        ("springs", self.springs.memory_map())
    }
}

#[kernel]
fn add_forces(springs: &Field<Spring, _>, masses: &mut Field<Mass, _>) {
    for s in springs {
        let [a, b] = springs.ends[s];
        let force = springs.bond[s].force(masses.x[a] - masses.x[b], masses.v[a] - masses.v[b]);
        masses.f[a] += force;
        masses.f[b] -= force;
    }
}

#[kernel]
fn add_resistance(
    springs: &Field<Spring, _>,
    masses: &Field<Mass, _>,
    p: &Field<DVec3, _>,
    q: &mut Field<DVec3, _>,
    rates: Rates,
) {
    for s in springs {
        let [a, b] = springs.ends[s];
        let resistance = springs.bond[s].resistance(masses.x[a] - masses.x[b], p[a] - p[b], rates);
        q[a] += resistance;
        q[b] -= resistance;
    }
}

#[kernel]
fn add_diagonal(springs: &Field<Spring, _>, masses: &Field<Mass, _>, diagonal: &mut Field<DVec3, _>, rates: Rates) {
    for s in springs {
        let [a, b] = springs.ends[s];
        let own = springs.bond[s].diagonal(masses.x[a] - masses.x[b], rates);
        diagonal[a] += own;
        diagonal[b] += own;
    }
}
