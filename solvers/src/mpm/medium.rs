//! What the driver asks of a medium in some dimensions and layouts.

use allotrope::prelude::*;
use allotrope::{MemoryMap, Permutation};

use super::MpmSetup;
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// The state of a medium in one pair of layouts, and the parts of a step. What surrounds them is compiled once, not in each pair.
pub(super) trait Medium: Send {
    /// # Errors
    /// If memory is refused.
    fn new(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Result<Self, String>
    where
        Self: Sized;

    /// Whether [`deform`](Self::deform) does anything.
    fn deforms(&self) -> bool {
        false
    }

    /// Empties the grid.
    fn clear(&mut self);

    /// Mass and momentum, from particles to the grid.
    fn scatter(&mut self);

    /// Momentum to velocity, gravity, walls, and colliders as they stand at that time in s. Tells how many nodes are
    /// not finite or move more than a cell a step.
    fn update_grid(&mut self, time: f64) -> u32;

    /// Velocity, from the grid to particles, which move and are deformed.
    fn gather(&mut self);

    /// Lets the materials yield, and makes the stress that the next step scatters.
    fn deform(&mut self) {}

    /// How many particles are not finite or moved more than a cell; none, where [`update_grid`](Self::update_grid) told
    /// none.
    fn broken(&self) -> u32;

    /// The first node of those around the particle at a place.
    fn cell(&self, place: usize) -> IVec3;

    /// Sorts the particles by cell.
    fn reorder(&mut self) -> Permutation;

    /// Number of particles.
    fn len(&self) -> usize;

    /// The particle at a place.
    fn particle(&self, place: usize) -> Particle;

    /// The members of the particles, in the order in which they lie in memory.
    fn members(&self) -> Vec<Array>;

    /// Puts saved members in their places.
    ///
    /// # Errors
    /// If one is missing or of another length; then nothing is changed.
    fn set_members(&mut self, state: &State) -> Result<(), String>;

    /// Mass and velocity of the nodes.
    fn nodes(&self) -> Vec<Array>;

    /// The mass on the grid.
    fn grid_mass(&self) -> f64;

    /// Bytes of all fields.
    fn bytes(&self) -> usize;

    /// Where the records of particles and of nodes lie.
    fn memory_maps(&self) -> [MemoryMap<'_>; 2];
}

/// A particle, whatever its dimensions and layout.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Particle {
    pub(super) x: [f64; 3],
    pub(super) v: [f64; 3],
    /// Gradient of the velocity that it carries, `c[row][column]`; zero where it carries none.
    pub(super) c: [[f64; 3]; 3],
    /// Which of the scene's materials it is of.
    pub(super) material: u32,
    /// Pressure in Pa: the mean of the normal Kirchhoff stresses, compression positive.
    pub(super) pressure: f64,
    /// Elastic energy a volume at rest, in J/m^3.
    pub(super) elastic: f64,
}

/// The key by which particles are sorted: their first node, in blocks of 4 nodes an axis, block after block, so that
/// neighbours in memory share nodes of the grid, whatever its layout.
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope_solvers::mpm::block_major;
/// let row: Vec<u64> = (0..6).map(|j| block_major(uvec3(0, j, 0), [9, 10, 1])).collect();
/// assert_eq!(row, [0, 1, 2, 3, 16, 17]);
/// assert_eq!(block_major(uvec3(1, 0, 0), [9, 10, 1]), 4);
/// assert_eq!(block_major(uvec3(4, 0, 0), [9, 10, 1]), 48);
/// assert_eq!(block_major(uvec3(1, 2, 3), [8, 8, 8]), 16 + 8 + 3);
/// assert_eq!(block_major(uvec3(4, 0, 0), [8, 8, 8]), 4 * 64);
/// ```
pub fn block_major(node: UVec3, shape: [usize; 3]) -> u64 {
    let blocks = shape.map(|nodes| nodes.div_ceil(4) as u64);
    let (block, inner) = (node / 4, node % 4);
    let outer = (u64::from(block.x) * blocks[1] + u64::from(block.y)) * blocks[2] + u64::from(block.z);
    let cells = if shape[2] == 1 { 16 } else { 64 };
    let depth = if shape[2] == 1 { 1 } else { 4 };
    outer * cells + u64::from((inner.x * 4 + inner.y) * depth + inner.z)
}
