//! The fluid in any layouts.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{MemoryMap, Permutation};

use super::kernels::{clear, count_broken, grid_to_particle, particle_to_grid, update_grid};
use super::parameters::Mpm;
use super::records::{Node, Point};
use crate::mpm::MpmSetup;
use crate::mpm::convert::{matrices, matrix, node, rows, saved_matrices, saved_vectors, triple, vector, vectors};
use crate::mpm::grid;
use crate::mpm::medium::{Medium, Particle, block_major};
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// The first node of those around a particle.
fn base<X: Spatial>(point: &Point<X>, mpm: &Mpm<X>) -> IVec3 {
    node::<X>((point.x * mpm.inv_dx - 0.5).to_index())
}

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(in crate::mpm) struct Fluid<X: Spatial, P: Layout<I>, G: Layout<X>> {
    points: Field<Point<X>, P>,
    grid: Field<Node<X>, G, X>,
    /// Nodes along each axis.
    shape: [usize; 3],
    mpm: Mpm<X>,
}

/// The arrays of what so many particles hold, compiled once for all layouts.
fn arrays_of_points<X: Spatial>(count: usize, point: &dyn Fn(usize) -> Point<X>) -> Vec<Array> {
    vec![
        vectors::<X>("position", (0..count).map(|p| point(p).x)),
        vectors::<X>("velocity", (0..count).map(|p| point(p).v)),
        matrices::<X>("velocity_gradient", (0..count).map(|p| point(p).c)),
        Array::floats("volume_ratio", (0..count).map(|p| [point(p).j])),
    ]
}

impl<X: Spatial, P: Layout<I>, G: Layout<X>> Medium for Fluid<X, P, G> {
    fn new(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Result<Self, String> {
        let fault = |error: allotrope::ShapeError| error.to_string();
        let mut points = Field::<Point<X>, P>::try_new([particles.x.len()]).map_err(fault)?;
        let grid = grid::make(setup)?;
        for (p, ((x, v), c)) in particles.x.iter().zip(&particles.v).zip(&particles.c).enumerate() {
            let (x, v) = (vector::<X, f32>(*x), vector::<X, f32>(*v));
            points.set(p, Point { x, v, c: matrix::<X, f32>(*c), j: 1.0 });
        }
        Ok(Self { points, grid, shape: grid::shape(setup), mpm: Mpm::new(scene, setup) })
    }

    fn clear(&mut self) {
        // Of a sparse grid the blocks go back, and those are made anew that the particles touch.
        if G::SPARSE { self.grid.clear() } else { clear(&mut self.grid) }
    }

    fn scatter(&mut self) {
        particle_to_grid(&self.points, &mut self.grid, &self.mpm);
    }

    fn update_grid(&mut self, _time: f64) -> u32 {
        update_grid(&mut self.grid, &self.mpm)
    }

    fn gather(&mut self) {
        grid_to_particle(&mut self.points, &self.grid, &self.mpm);
    }

    fn broken(&self) -> u32 {
        count_broken(&self.points, &self.mpm)
    }

    fn cell(&self, place: usize) -> IVec3 {
        base(&self.points.get(place), &self.mpm)
    }

    fn reorder(&mut self) -> Permutation {
        let (mpm, nodes) = (self.mpm, self.shape);
        self.points.reorder_by_key(|point| block_major(base(point, &mpm).max(IVec3::ZERO).as_uvec3(), nodes))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let Point { x, v, c, j } = self.points.get(place);
        let (pressure, elastic) = self.mpm.of_volume(j);
        Particle { x: triple::<X>(x), v: triple::<X>(v), c: rows::<X>(c), material: 0, pressure, elastic }
    }

    fn members(&self) -> Vec<Array> {
        arrays_of_points(self.len(), &|p| self.points.get(p))
    }

    fn set_members(&mut self, state: &State) -> Result<(), String> {
        let count = self.len();
        let x = saved_vectors::<X>(state, "position", count)?;
        let v = saved_vectors::<X>(state, "velocity", count)?;
        let c = saved_matrices::<X>(state, "velocity_gradient", count)?;
        let j = state.floats::<1>("volume_ratio", count)?;
        for (p, &[j]) in j.iter().enumerate() {
            self.points.set(p, Point { x: x(p), v: v(p), c: c(p), j });
        }
        Ok(())
    }

    fn nodes(&self) -> Vec<Array> {
        let node = grid::nodes(&self.grid, self.shape);
        grid::arrays::<X>(self.shape, &|n| {
            let Node { v, m } = node(n);
            (v, m)
        })
    }

    fn grid_mass(&self) -> f64 {
        grid::sum(&self.grid, |node| f64::from(node.m))
    }

    fn bytes(&self) -> usize {
        self.points.bytes() + self.grid.bytes()
    }

    fn memory_maps(&self) -> [MemoryMap<'_>; 2] {
        [self.points.memory_map(), self.grid.memory_map()]
    }
}
