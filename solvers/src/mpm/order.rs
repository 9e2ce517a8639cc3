//! When the order of particles in memory has decayed so far that sorting them pays.
//!
//! Sorted particles find the nodes of their neighbours in the caches. The further neighbours in memory drift apart, the more often a step waits
//! for memory instead, until a sort would have cost less than the waiting. Both are told by the particles alone, so that runs can be repeated: by
//! the share of neighbours in memory that stand far apart on the grid.

use allotrope::prelude::*;

use crate::{Array, State};

/// Steps from one look to the next.
const LOOK_EVERY: u64 = 8;

/// Neighbours in memory are far apart from so many cells along an axis on: their nodes then lie in other rows, pages and cache lines.
const FAR: i32 = 8;

/// One in so many neighbours is looked at, but so many at least and at most.
const ONE_IN: usize = 256;
const LOOKS: [usize; 2] = [64, 4096];

/// A sort pays when the shares of all steps since the last one, beyond those that a sort leaves, come to so much: it takes about as long as this
/// part of what a step over particles in no order loses. Measured with 2^20 particles on 1024^2 nodes.
const SORT_PAYS: f64 = 0.25;

/// What is known of the order.
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope_solvers::mpm::order::Order;
///
/// // Particles along a line: nothing drifts apart.
/// let cell = |place: usize| IVec3::new(0, place as i32 / 4, 0);
/// let mut order = Order::default();
/// assert!(order.has_decayed(0, 1000, cell), "what was never sorted is sorted first");
/// order.renew(1000, cell);
/// assert!((1..500).all(|step| !order.has_decayed(step, 1000, cell)));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Order {
    /// Neighbours far apart after the last sort, of those that are looked at; not known before it.
    sorted: Option<u32>,
    /// Those beyond, summed over the steps since.
    lost: u32,
}

impl Order {
    /// Whether to sort before the next step, given how many steps were done. `cell` tells the cell of the particle at a place.
    pub fn has_decayed(&mut self, steps: u64, particles: usize, cell: impl Fn(usize) -> IVec3) -> bool {
        let looks = looks(particles);
        let Some(sorted) = self.sorted else { return true };
        if steps.is_multiple_of(LOOK_EVERY) {
            let beyond = apart(particles, cell).saturating_sub(sorted);
            self.lost = self.lost.saturating_add(beyond * LOOK_EVERY as u32);
        }
        f64::from(self.lost) > SORT_PAYS * looks as f64
    }

    /// Notes that particles have just been sorted.
    pub fn renew(&mut self, particles: usize, cell: impl Fn(usize) -> IVec3) {
        *self = Self { sorted: Some(apart(particles, cell)), lost: 0 };
    }

    /// What a run needs to go on.
    pub(super) fn save(&self) -> Array {
        Array::whole("order", self.sorted.map_or(vec![0; 3], |sorted| vec![1, sorted, self.lost]))
    }

    /// Goes on from what was saved.
    ///
    /// # Errors
    /// If it is not there.
    pub(super) fn restore(state: &State) -> Result<Self, String> {
        let order = state.whole("order", 3)?;
        Ok(Self { sorted: (order[0] != 0).then_some(order[1]), lost: order[2] })
    }
}

/// How many neighbours are looked at.
fn looks(particles: usize) -> usize {
    (particles / ONE_IN).clamp(LOOKS[0], LOOKS[1]).min(particles.saturating_sub(1))
}

/// How many of them are far apart.
fn apart(particles: usize, cell: impl Fn(usize) -> IVec3) -> u32 {
    let looks = looks(particles);
    let far = |look: &usize| {
        let place = look * (particles - 1) / looks;
        (cell(place + 1) - cell(place)).abs().max_element() >= FAR
    };
    (0..looks).filter(far).count() as u32
}
