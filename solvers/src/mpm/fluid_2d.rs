//! The fluid in a plane, in any layouts.

use allotrope::Permutation;
use allotrope::prelude::*;

use super::fluid::{Fluid, Particle, block_major};
use super::kernels_2d::{clear, count_broken, grid_to_particle, particle_to_grid, update_grid};
use super::parameters::Mpm;
use super::records::{Node2, Point2};
use crate::scene::Particles;

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(super) struct Fluid2<P: Layout<I>, G: Layout<Ij>> {
    points: Field<Point2, P>,
    grid: Field<Node2, G, Ij>,
}

impl<P: Layout<I>, G: Layout<Ij>> Fluid for Fluid2<P, G> {
    type Parameters = Mpm<Vec2>;

    fn new(particles: &Particles, [i, j, _]: [usize; 3]) -> Result<Self, String> {
        let mut points = Field::<Point2, P>::try_new([particles.x.len()]).map_err(|error| error.to_string())?;
        let grid = Field::<Node2, G>::try_new([i, j]).map_err(|error| error.to_string())?;
        for (p, ((x, v), c)) in particles.x.iter().zip(&particles.v).zip(&particles.c).enumerate() {
            let vector = |v: &[f64; 3]| vec2(v[0] as f32, v[1] as f32);
            let c = Mat2::from_cols(vec2(c[0][0] as f32, c[1][0] as f32), vec2(c[0][1] as f32, c[1][1] as f32));
            points.set(p, Point2 { x: vector(x), v: vector(v), c, j: 1.0 });
        }
        Ok(Self { points, grid })
    }

    fn clear(&mut self) {
        clear(&mut self.grid);
    }

    fn scatter(&mut self, mpm: &Mpm<Vec2>) {
        particle_to_grid(&self.points, &mut self.grid, mpm);
    }

    fn update_grid(&mut self, mpm: &Mpm<Vec2>) -> u32 {
        update_grid(&mut self.grid, mpm)
    }

    fn gather(&mut self, mpm: &Mpm<Vec2>) {
        grid_to_particle(&mut self.points, &self.grid, mpm);
    }

    fn broken(&self, mpm: &Mpm<Vec2>) -> u32 {
        count_broken(&self.points, mpm)
    }

    fn reorder(&mut self, mpm: &Mpm<Vec2>) -> Permutation {
        let [rows, columns] = self.grid.shape();
        self.points
            .reorder_by_key(|point| block_major((point.x * mpm.inv_dx - 0.5).as_uvec2().extend(0), [rows, columns, 1]))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let Point2 { x, v, c, .. } = self.points.get(place);
        let vector = |v: Vec2| [f64::from(v.x), f64::from(v.y), 0.0];
        Particle { x: vector(x), v: vector(v), c: [vector(c.row(0)), vector(c.row(1)), [0.0; 3]] }
    }

    fn grid_mass(&self) -> f64 {
        self.grid.members().m.to_vec().into_iter().map(f64::from).sum()
    }

    fn bytes(&self) -> usize {
        self.points.bytes() + self.grid.bytes()
    }
}
