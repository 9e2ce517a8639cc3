//! The fluid in space, in any layouts.

use allotrope::Permutation;
use allotrope::prelude::*;

use super::kernels_3d::{clear, count_broken, grid_to_particle, particle_to_grid, update_grid};
use super::parameters::Mpm;
use super::records::{Node3, Point3};
use crate::mpm::medium::{Medium, Particle, block_major};
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(in crate::mpm) struct Fluid3<P: Layout<I>, G: Layout<Ijk>> {
    points: Field<Point3, P>,
    grid: Field<Node3, G, Ijk>,
    mpm: Mpm<Vec3>,
}

impl<P: Layout<I>, G: Layout<Ijk>> Medium for Fluid3<P, G> {
    const DEFORMS: bool = false;

    fn new(scene: &Scene, particles: &Particles) -> Result<Self, String> {
        let mut points = Field::<Point3, P>::try_new([particles.x.len()]).map_err(|error| error.to_string())?;
        let grid = Field::<Node3, G>::try_new(scene.grid).map_err(|error| error.to_string())?;
        for (p, ((x, v), c)) in particles.x.iter().zip(&particles.v).zip(&particles.c).enumerate() {
            let vector = |v: [f64; 3]| Vec3::from_array(v.map(|component| component as f32));
            let column = |n: usize| vector([c[0][n], c[1][n], c[2][n]]);
            let c = Mat3::from_cols(column(0), column(1), column(2));
            points.set(p, Point3 { x: vector(*x), v: vector(*v), c, j: 1.0 });
        }
        Ok(Self { points, grid, mpm: Mpm::space(scene) })
    }

    fn clear(&mut self) {
        clear(&mut self.grid);
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

    fn reorder(&mut self) -> Permutation {
        let inv_dx = self.mpm.inv_dx;
        let shape = self.grid.shape();
        self.points.reorder_by_key(|point| block_major((point.x * inv_dx - 0.5).as_uvec3(), shape))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let Point3 { x, v, c, j } = self.points.get(place);
        let (pressure, elastic) = self.mpm.of_volume(j);
        let vector = |v: Vec3| v.to_array().map(f64::from);
        let c = [0, 1, 2].map(|row| vector(c.row(row)));
        Particle { x: vector(x), v: vector(v), c, material: 0, pressure, elastic }
    }

    fn members(&self) -> Vec<Array> {
        vec![
            Array::floats("position", self.points.iter().map(|point| point.x.to_array())),
            Array::floats("velocity", self.points.iter().map(|point| point.v.to_array())),
            Array::floats("velocity_gradient", self.points.iter().map(|point| point.c.to_cols_array())),
            Array::floats("volume_ratio", self.points.iter().map(|point| [point.j])),
        ]
    }

    fn set_members(&mut self, state: &State) -> Result<(), String> {
        let count = self.len();
        let x = state.floats::<3>("position", count)?;
        let v = state.floats::<3>("velocity", count)?;
        let c = state.floats::<9>("velocity_gradient", count)?;
        let j = state.floats::<1>("volume_ratio", count)?;
        for p in 0..count {
            let (x, v) = (Vec3::from_array(x[p]), Vec3::from_array(v[p]));
            self.points.set(p, Point3 { x, v, c: Mat3::from_cols_array(&c[p]), j: j[p][0] });
        }
        Ok(())
    }

    fn nodes(&self) -> Vec<Array> {
        vec![
            Array::floats("mass", self.grid.iter().map(|node| [node.m])),
            Array::floats("velocity", self.grid.iter().map(|node| node.v.to_array())),
        ]
    }

    fn grid_mass(&self) -> f64 {
        self.grid.members().m.to_vec().into_iter().map(f64::from).sum()
    }

    fn bytes(&self) -> usize {
        self.points.bytes() + self.grid.bytes()
    }
}
