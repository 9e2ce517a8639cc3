//! A continuum in any layouts, whatever its particles carry.

use allotrope::Permutation;
use allotrope::prelude::*;

use super::carrier::Carrier;
use super::{DIMENSIONS, Matrix, Nodes, Transfers, Vector, extents, matrix, node, rows, triple, vector};
use crate::mpm::materials::Model;
use crate::mpm::medium::{Medium, Particle, block_major};
use crate::mpm::obstacles::Obstacles;
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(in crate::mpm) struct Continuum<C: Carrier, P: Layout<I>, G: Layout<Nodes>> {
    points: Field<C::Point, P>,
    grid: Field<C::Node, G, Nodes>,
    mpm: Transfers,
    obstacles: Obstacles,
    materials: Vec<Model>,
}

/// What every particle holds, whatever it carries.
#[derive(Clone, Copy, Debug)]
pub(in crate::mpm) struct Body {
    pub(super) x: Vector,
    pub(super) v: Vector,
    /// Zero where none is carried.
    pub(super) c: Matrix,
    pub(super) stress: Matrix,
    pub(super) mass: f32,
    pub(super) deformation_gradient: Matrix,
    pub(super) plastic: Vec2,
    pub(super) material: u32,
}

impl<C: Carrier, P: Layout<I>, G: Layout<Nodes>> Medium for Continuum<C, P, G> {
    const DEFORMS: bool = true;

    fn new(scene: &Scene, particles: &Particles) -> Result<Self, String> {
        let fault = |error: allotrope::ShapeError| error.to_string();
        let mpm = Transfers::new(scene);
        let mut points = Field::<C::Point, P>::try_new([particles.x.len()]).map_err(fault)?;
        for p in 0..particles.x.len() {
            let material = &scene.materials[particles.material[p] as usize];
            let body = Body {
                x: vector(particles.x[p]),
                v: vector(particles.v[p]),
                c: matrix(particles.c[p]),
                stress: Matrix::ZERO,
                mass: (scene.particle_volume() * material.density) as f32,
                deformation_gradient: Matrix::IDENTITY,
                plastic: Vec2::from_array(material.model.initial_plastic()),
                material: particles.material[p],
            };
            points.set(p, C::point(&body, &mpm));
        }
        let grid = Field::<C::Node, G>::try_new(extents(scene.grid)).map_err(fault)?;
        let materials = scene.materials.iter().map(|material| material.model).collect();
        Ok(Self { points, grid, mpm, obstacles: Obstacles::new(scene), materials })
    }

    fn clear(&mut self) {
        C::clear(&mut self.grid);
    }

    fn scatter(&mut self) {
        C::scatter(&self.points, &mut self.grid, &self.mpm);
    }

    fn update_grid(&mut self, time: f64) -> u32 {
        self.obstacles.move_to(time);
        C::update_grid(&mut self.grid, &self.mpm, &self.obstacles)
    }

    fn gather(&mut self) {
        C::gather(&mut self.points, &self.grid, &self.mpm);
    }

    fn deform(&mut self) {
        C::deform(&mut self.points, &self.materials);
    }

    fn broken(&self) -> u32 {
        C::count_broken(&self.points, &self.mpm)
    }

    fn reorder(&mut self) -> Permutation {
        let shape = self.grid.shape();
        let nodes: [usize; 3] = std::array::from_fn(|axis| shape.get(axis).copied().unwrap_or(1));
        let mpm = self.mpm;
        self.points
            .reorder_by_key(|point| block_major(node(mpm.stencil(C::body(point, &mpm).x).base).as_uvec3(), nodes))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let body = C::body(&self.points.get(place), &self.mpm);
        let trace: f64 = (0..DIMENSIONS).map(|axis| f64::from(body.stress.col(axis)[axis])).sum();
        let model = &self.materials[body.material as usize];
        Particle {
            x: triple(body.x),
            v: triple(body.v),
            c: rows(body.c),
            material: body.material,
            pressure: -trace / DIMENSIONS as f64,
            elastic: f64::from(model.energy(body.deformation_gradient, body.plastic.to_array())),
        }
    }

    fn members(&self) -> Vec<Array> {
        let bodies = || self.points.iter().map(|point| C::body(&point, &self.mpm));
        let mut arrays = vec![
            Array::floats("position", bodies().map(|body| body.x.to_array())),
            Array::floats("stress", bodies().map(|body| body.stress.to_cols_array())),
            Array::floats("deformation_gradient", bodies().map(|body| body.deformation_gradient.to_cols_array())),
            Array::floats("plastic", bodies().map(|body| body.plastic.to_array())),
            Array::whole("material", bodies().map(|body| body.material).collect()),
        ];
        arrays.extend(C::carried(&mut self.points.iter()));
        arrays
    }

    fn set_members(&mut self, state: &State) -> Result<(), String> {
        const SQUARE: usize = DIMENSIONS * DIMENSIONS;
        let count = self.len();
        let x = state.floats::<DIMENSIONS>("position", count)?;
        let stress = state.floats::<SQUARE>("stress", count)?;
        let deformation_gradient = state.floats::<SQUARE>("deformation_gradient", count)?;
        let plastic = state.floats::<2>("plastic", count)?;
        let material = state.whole("material", count)?;
        if let Some(unknown) = material.iter().find(|&&material| material as usize >= self.materials.len()) {
            return Err(format!("array `material` holds {unknown}, and there are {} materials", self.materials.len()));
        }
        let mut points = self.points.clone();
        C::set_carried(&mut points, state)?;
        // A particle's mass follows from its material; in another order, another particle's is in its place.
        let mut mass = vec![0.0; self.materials.len()];
        for body in self.points.iter().map(|point| C::body(&point, &self.mpm)) {
            mass[body.material as usize] = body.mass;
        }
        for p in 0..count {
            let mut point = points.get(p);
            let body = Body {
                x: Vector::from_array(x[p]),
                stress: Matrix::from_cols_array(&stress[p]),
                mass: mass[material[p] as usize],
                deformation_gradient: Matrix::from_cols_array(&deformation_gradient[p]),
                plastic: Vec2::from_array(plastic[p]),
                material: material[p],
                ..C::body(&point, &self.mpm)
            };
            C::set_body(&mut point, &body);
            points.set(p, point);
        }
        self.points = points;
        Ok(())
    }

    fn nodes(&self) -> Vec<Array> {
        vec![
            Array::floats("mass", self.grid.iter().map(|node| [C::node(&node).1])),
            Array::floats("velocity", self.grid.iter().map(|node| C::node(&node).0.to_array())),
        ]
    }

    fn grid_mass(&self) -> f64 {
        self.grid.iter().map(|node| f64::from(C::node(&node).1)).sum()
    }

    fn bytes(&self) -> usize {
        self.points.bytes() + self.grid.bytes()
    }
}
