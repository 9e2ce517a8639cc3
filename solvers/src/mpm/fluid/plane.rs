//! The fluid in a plane, in any layouts.

use allotrope::Permutation;
use allotrope::prelude::*;

use super::kernels_2d::{clear, count_broken, grid_to_particle, particle_to_grid, update_grid};
use super::parameters::Mpm;
use super::records::{Node2, Point2};
use crate::mpm::medium::{Medium, Particle, block_major};
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(in crate::mpm) struct Fluid2<P: Layout<I>, G: Layout<Ij>> {
    points: Field<Point2, P>,
    grid: Field<Node2, G, Ij>,
    mpm: Mpm<Vec2>,
}

impl<P: Layout<I>, G: Layout<Ij>> Medium for Fluid2<P, G> {
    const DEFORMS: bool = false;

    fn new(scene: &Scene, particles: &Particles) -> Result<Self, String> {
        let mut points = Field::<Point2, P>::try_new([particles.x.len()]).map_err(|error| error.to_string())?;
        let grid = Field::<Node2, G>::try_new([scene.grid[0], scene.grid[1]]).map_err(|error| error.to_string())?;
        for (p, ((x, v), c)) in particles.x.iter().zip(&particles.v).zip(&particles.c).enumerate() {
            let vector = |v: &[f64; 3]| vec2(v[0] as f32, v[1] as f32);
            let c = Mat2::from_cols(vec2(c[0][0] as f32, c[1][0] as f32), vec2(c[0][1] as f32, c[1][1] as f32));
            points.set(p, Point2 { x: vector(x), v: vector(v), c, j: 1.0 });
        }
        Ok(Self { points, grid, mpm: Mpm::plane(scene) })
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
        let [rows, columns] = self.grid.shape();
        self.points
            .reorder_by_key(|point| block_major((point.x * inv_dx - 0.5).as_uvec2().extend(0), [rows, columns, 1]))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let Point2 { x, v, c, j } = self.points.get(place);
        let (pressure, elastic) = self.mpm.of_volume(j);
        let vector = |v: Vec2| [f64::from(v.x), f64::from(v.y), 0.0];
        let c = [vector(c.row(0)), vector(c.row(1)), [0.0; 3]];
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
        let x = state.floats::<2>("position", count)?;
        let v = state.floats::<2>("velocity", count)?;
        let c = state.floats::<4>("velocity_gradient", count)?;
        let j = state.floats::<1>("volume_ratio", count)?;
        for p in 0..count {
            let (x, v) = (Vec2::from_array(x[p]), Vec2::from_array(v[p]));
            self.points.set(p, Point2 { x, v, c: Mat2::from_cols_array(&c[p]), j: j[p][0] });
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
