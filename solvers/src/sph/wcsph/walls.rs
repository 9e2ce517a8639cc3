//! Particles of walls.

use allotrope::ShapeError;
use allotrope::prelude::*;
use allotrope::spatial::*;

use super::WallParticle;
use super::kernels::measure;
use crate::sph::Smoothing;
use crate::sph::neighbours::{Options, Search, SortedCells};

/// The particles of all walls, sorted by cell.
#[derive(Clone, Debug)]
pub struct Walls<X: Spatial> {
    /// The particles.
    pub particles: Field<WallParticle<X>, Soa>,
    /// Where each of their cells begins.
    pub cells: SortedCells<X>,
}

impl<X: Spatial> Walls<X> {
    /// Walls of particles at these places, for a smoothing kernel.
    ///
    /// # Errors
    /// Where memory is refused.
    pub fn new(places: &[X::Vec<f32>], kernel: &Smoothing) -> Result<Self, ShapeError> {
        let mut particles = Field::<WallParticle<X>, Soa>::try_new([places.len()])?;
        let lower = places.iter().copied().reduce(|a, b| a.min(b)).unwrap_or_default();
        let upper = places.iter().copied().reduce(|a, b| a.max(b)).unwrap_or_default();
        let options = Options { radius: kernel.support(), lower, upper, ..Options::new(places.len()) };
        let mut cells = SortedCells::new(&options)?;
        places.iter().enumerate().for_each(|(b, &x)| particles.set(b, WallParticle { x, volume: 0.0 }));
        particles.reorder_by_key(|wall| cells.key(wall.x));
        let mut x = Field::<X::Vec<f32>, Soa>::try_new([places.len()])?;
        x.copy_from_slice(&particles.members().x.to_vec());
        // Sorted cells are never too full.
        let _ = cells.update(&x);
        measure(&mut particles, cells.near(), &cells.walk(), kernel);
        Ok(Self { particles, cells })
    }

    /// Bytes of all fields.
    pub fn bytes(&self) -> usize {
        self.particles.bytes() + Search::<X>::bytes(&self.cells)
    }
}
