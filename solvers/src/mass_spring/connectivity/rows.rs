//! A list of springs for each mass.

use allotrope::prelude::*;

use super::{Connectivity, Vectors};
use crate::mass_spring::records::{Link, Mass, Rates, Spring};

type Lists = layout!(dense(i).dynamic(j, 1024, chunk = 16).aos);

/// As many springs as a mass can have.
const MOST: usize = 1024;

/// A list of springs for each mass, which sums up its own forces.
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
}

#[kernel]
fn add_forces(links: &Field<Link, Lists, Ij>, masses: &mut Field<Mass, _>) {
    for m in masses {
        let (x, v) = (masses.x[m], masses.v[m]);
        let mut sum = DVec3::ZERO;
        for e in links.row(m) {
            let Link { other, bond } = links[e];
            sum += bond.force(x - masses.x[other], v - masses.v[other]);
        }
        masses.f[m] += sum;
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
    for m in q {
        let (x, own) = (masses.x[m], p[m]);
        let mut sum = DVec3::ZERO;
        for e in links.row(m) {
            let Link { other, bond } = links[e];
            sum += bond.resistance(x - masses.x[other], own - p[other], rates);
        }
        q[m] += sum;
    }
}

#[kernel]
fn add_diagonal(links: &Field<Link, Lists, Ij>, masses: &Field<Mass, _>, diagonal: &mut Field<DVec3, _>, rates: Rates) {
    for m in diagonal {
        let x = masses.x[m];
        let mut sum = DVec3::ZERO;
        for e in links.row(m) {
            let Link { other, bond } = links[e];
            sum += bond.diagonal(x - masses.x[other], rates);
        }
        diagonal[m] += sum;
    }
}
