//! The fluid in one layout, with its neighbours found in one way.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{MemoryMap, Permutation, ShapeError};

use super::clock::TimeStep;
use super::kernels::{accelerate, advance_density, drift, kick, note, renew_state, sum_density};
use super::walls::Walls;
use super::{Fluid, Particle};
use crate::sph::neighbours::{Crowded, Options, Search};

/// How density follows the particles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Density {
    /// By summation over neighbours.
    Summation,
    /// By the continuity equation: at a free surface it stays what it was.
    #[default]
    Continuity,
}

/// A part of a step, whose time is told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Sorting, and finding neighbours.
    Neighbours,
    /// Density and pressure.
    Density,
    /// Accelerations.
    Forces,
    /// Velocities and positions.
    Motion,
}

impl Part {
    /// Their names, in order.
    pub const NAMES: &'static [&'static str] = &["neighbours", "density", "forces", "motion"];
}

/// Why a step could not be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// There are more neighbours than a list holds.
    Crowded(Crowded),
    /// So many particles moved farther than a smoothing length, or are not finite.
    Broken(u32),
}

/// Particles in the layout `P`, neighbours found by `S`.
#[derive(Debug)]
pub struct Medium<X: Spatial, P: Layout<I>, S: Search<X>> {
    /// The particles.
    pub particles: Field<Particle<X>, P>,
    /// The fluid's constants.
    pub fluid: Fluid<X>,
    /// The walls.
    pub walls: Walls<X>,
    /// How density is found.
    pub density: Density,
    /// Where particles were when neighbours were found last.
    pub anchors: Field<X::Vec<f32>, Soa>,
    /// How far particles may have moved since, in m; infinite, if neighbours are to be found anew.
    pub moved: f32,
    search: S,
    skin: f32,
}

impl<X: Spatial, P: Layout<I>, S: Search<X>> Medium<X, P, S> {
    /// A fluid of particles at these places with these velocities, at rest's density.
    ///
    /// # Errors
    /// Where memory is refused.
    #[allow(clippy::type_complexity, reason = "a place and a velocity")]
    pub fn new(
        start: &[(X::Vec<f32>, X::Vec<f32>)],
        walls: Walls<X>,
        fluid: Fluid<X>,
        density: Density,
        options: &Options<X>,
    ) -> Result<Self, ShapeError> {
        let skin = if S::LASTS { options.skin } else { 0.0 };
        let options = Options { particles: start.len(), radius: fluid.kernel.support(), skin, ..*options };
        let mut particles = Field::<Particle<X>, P>::try_new([start.len()])?;
        for (p, &(x, v)) in start.iter().enumerate() {
            particles.set(p, Particle { x, v, rho: fluid.density, ..Particle::default() });
        }
        renew_state(&mut particles, &fluid);
        let anchors = Field::<X::Vec<f32>, Soa>::try_new([start.len()])?;
        Ok(Self { particles, fluid, walls, density, anchors, moved: f32::INFINITY, search: S::new(&options)?, skin })
    }

    /// Whether neighbours are found anew in the next step.
    pub fn is_stale(&self) -> bool {
        !S::LASTS || self.moved >= 0.5 * self.skin
    }

    /// Whether its neighbours are found in such a way that its particles must be sorted for it.
    pub fn must_be_sorted(&self) -> bool {
        S::SORTED
    }

    /// Sorts the particles by cell.
    pub fn sort(&mut self) -> Permutation {
        let search = &self.search;
        self.particles.reorder_by_key(|particle| search.key(particle.x))
    }

    /// Finds neighbours anew.
    ///
    /// # Errors
    /// Where there are more of them than a list holds.
    pub fn find_neighbours(&mut self) -> Result<(), Crowded> {
        note(&self.particles, &mut self.anchors);
        self.moved = 0.0;
        self.search.update(&self.anchors)
    }

    /// Finds again the neighbours that were found at the anchors.
    ///
    /// # Errors
    /// As [`find_neighbours`](Self::find_neighbours).
    pub fn restore_neighbours(&mut self) -> Result<(), Crowded> {
        if self.is_stale() { Ok(()) } else { self.search.update(&self.anchors) }
    }

    /// Advances by a step of at most `most` s, neighbours having been found. `lap` is called after each part.
    ///
    /// # Errors
    /// Where something has gone wrong.
    pub fn advance(&mut self, most: f64, adaptive: bool, mut lap: impl FnMut(Part)) -> Result<TimeStep, Fault> {
        let (near, walk) = (self.search.near(), self.search.walk());
        let (walls, near_walls, walk_walls) = (&self.walls.particles, self.walls.cells.near(), self.walls.cells.walk());
        let (particles, fluid) = (&mut self.particles, &self.fluid);
        if self.density == Density::Summation {
            sum_density(particles, near, &walk, walls, near_walls, &walk_walls, fluid);
            lap(Part::Density);
        }
        let extremes = accelerate(particles, near, &walk, walls, near_walls, &walk_walls, fluid);
        lap(Part::Forces);
        let mut step = TimeStep::new(fluid, &extremes, most);
        if !adaptive {
            step.dt = most;
        }
        let dt = step.dt as f32;
        let (fastest, broken) = kick(particles, dt, fluid.kernel.smoothing_length());
        lap(Part::Motion);
        if broken > 0 {
            return Err(Fault::Broken(broken));
        }
        if self.density == Density::Continuity {
            advance_density(particles, near, &walk, walls, near_walls, &walk_walls, fluid, dt);
            lap(Part::Density);
        }
        drift(particles, dt);
        self.moved += 1.001 * fastest.sqrt() * dt;
        lap(Part::Motion);
        Ok(step)
    }

    /// Puts particles in their places, as they were saved.
    pub fn set(&mut self, p: usize, x: X::Vec<f32>, v: X::Vec<f32>, rho: f32) {
        let (push, sound) = self.fluid.state(rho);
        self.particles.set(p, Particle { x, v, rho, push, sound, ..Particle::default() });
    }

    /// Bytes of all fields.
    pub fn bytes(&self) -> usize {
        self.particles.bytes() + self.anchors.bytes() + self.walls.bytes() + self.search.bytes()
    }

    /// Where the records of particles lie, and what tells which are neighbours.
    pub fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        vec![("particles", self.particles.memory_map()), ("neighbours", self.search.near().memory_map())]
    }
}
