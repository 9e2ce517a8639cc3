//! A list of springs for each mass.

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::{Connectivity, Vectors};
use crate::mass_spring::records::{Link, Mass, Rates, Spring};

type Lists = layout!(dense(i).dynamic(j, 1024, chunk = 16).aos);

/// As many springs as a mass can have.
const MOST: usize = 1024;

/// A list of springs for each mass.
#[derive(Clone, Debug)]
pub struct Rows {
    links: Field<Link, Lists, Ij>,
}

impl<M: Layout<I>> Connectivity<M> for Rows {
    fn new(masses: usize, springs: &[Spring]) -> Result<Self, String> {
        let mut links = Field::<Link, Lists>::try_new([masses]).map_err(|fault| fault.to_string())?;
        for &Spring { ends: [a, b], bond } in springs {
            for (mass, other) in [(a, b), (b, a)] {
                if links.try_append(mass, Link { other, bond }).is_err() {
                    return Err(format!("mass {mass} has more than {MOST} springs, which its list does not hold"));
                }
            }
        }
        Ok(Self { links })
    }

    fn add_forces(&self, masses: &mut Field<Mass, M>) {
        add_forces(&self.links, masses);
    }

    fn add_resistance(&self, masses: &Field<Mass, M>, p: &Vectors, q: &mut Vectors, rates: Rates) {
        add_resistance(&self.links, masses, p, q, rates);
    }

    fn add_diagonal(&self, masses: &Field<Mass, M>, diagonal: &mut Vectors, rates: Rates) {
        add_diagonal(&self.links, masses, diagonal, rates);
    }

    fn bytes(&self) -> usize {
        self.links.bytes()
    }

    fn memory_map(&self) -> (&'static str, MemoryMap<'_>) {
        ("lists of springs", self.links.memory_map())
    }
}

// Entries are visited in the order in which they lie: a loop over the lists of each mass would look every entry up.

#[kernel]
fn add_forces(links: &Field<Link, Lists, Ij>, masses: &mut Field<Mass, _>) {
    for (m, e) in links {
        let other = links.other[(m, e)];
        let force = links.bond[(m, e)].force(masses.x[m] - masses.x[other], masses.v[m] - masses.v[other]);
        masses.f[m] += force;
    }
}

#[kernel]
fn add_resistance(
    links: &Field<Link, Lists, Ij>,
    masses: &Field<Mass, _>,
    p: &Field<DVec3, _>,
    q: &mut Field<DVec3, _>,
    rates: Rates,
) {
    for (m, e) in links {
        let other = links.other[(m, e)];
        q[m] += links.bond[(m, e)].resistance(masses.x[m] - masses.x[other], p[m] - p[other], rates);
    }
}

#[kernel]
fn add_diagonal(links: &Field<Link, Lists, Ij>, masses: &Field<Mass, _>, diagonal: &mut Field<DVec3, _>, rates: Rates) {
    for (m, e) in links {
        let other = links.other[(m, e)];
        diagonal[m] += links.bond[(m, e)].diagonal(masses.x[m] - masses.x[other], rates);
    }
}
