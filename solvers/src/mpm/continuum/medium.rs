//! A continuum in any layouts, whatever its particles carry.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{MemoryMap, Permutation};

use super::carrier::Carrier;
use super::{Dimensions, Transfers};
use crate::mpm::MpmSetup;
use crate::mpm::convert::{matrices, matrix, node, rows, saved_matrices, saved_vectors, triple, vector, vectors};
use crate::mpm::grid;
use crate::mpm::materials::Model;
use crate::mpm::medium::{Medium, Particle, block_major};
use crate::mpm::obstacles::Obstacles;
use crate::scene::{Particles, Scene};
use crate::{Array, State};

/// Particles in the layout `P`, grid nodes in the layout `G`.
pub(in crate::mpm) struct Continuum<X: Dimensions, C: Carrier<X>, P: Layout<I>, G: Layout<X>> {
    points: Field<C::Point, P>,
    grid: Field<C::Node, G, X>,
    /// Nodes along each axis.
    shape: [usize; 3],
    mpm: Transfers<X>,
    obstacles: Obstacles,
    materials: Vec<Model>,
}

/// What every particle holds, whatever it carries.
#[derive(Clone, Copy, Debug)]
pub(in crate::mpm) struct Body<X: Spatial> {
    pub(super) x: X::Vec<f32>,
    pub(super) v: X::Vec<f32>,
    /// Zero where none is carried.
    pub(super) c: X::Mat<f32>,
    pub(super) stress: X::Mat<f32>,
    pub(super) mass: f32,
    pub(super) deformation_gradient: X::Mat<f32>,
    pub(super) plastic: Vec2,
    pub(super) material: u32,
}

impl<X: Dimensions> Body<X> {
    /// A particle of a scene.
    fn of(setup: &MpmSetup, particles: &Particles, p: usize) -> Self {
        let material = &setup.materials[particles.material[p] as usize];
        Self {
            x: vector::<X, f32>(particles.x[p]),
            v: vector::<X, f32>(particles.v[p]),
            c: matrix::<X, f32>(particles.c[p]),
            stress: X::Mat::<f32>::zero(),
            mass: (setup.particle_volume() * material.density) as f32,
            deformation_gradient: X::Mat::<f32>::identity(),
            plastic: Vec2::from_array(material.model.initial_plastic()),
            material: particles.material[p],
        }
    }
}

/// Changes the particle of a number by a function.
type Changing<'a, X> = dyn FnMut(usize, &dyn Fn(&mut Body<X>)) + 'a;

/// Puts saved members of so many particles in their places, compiled once for all layouts: `set` is given what changes each.
fn set_bodies<X: Dimensions>(
    state: &State,
    count: usize,
    materials: usize,
    body: &dyn Fn(usize) -> Body<X>,
    set: &mut Changing<'_, X>,
) -> Result<(), String> {
    let x = saved_vectors::<X>(state, "position", count)?;
    let stress = saved_matrices::<X>(state, "stress", count)?;
    let deformation_gradient = saved_matrices::<X>(state, "deformation_gradient", count)?;
    let plastic = state.floats::<2>("plastic", count)?;
    let material = state.whole("material", count)?;
    if let Some(unknown) = material.iter().find(|&&material| material as usize >= materials) {
        return Err(format!("array `material` holds {unknown}, and there are {materials} materials"));
    }
    // A particle's mass follows from its material; in another order, another particle's is in its place.
    let mut mass = vec![0.0; materials];
    for body in (0..count).map(body) {
        mass[body.material as usize] = body.mass;
    }
    for p in 0..count {
        set(p, &|body| {
            *body = Body {
                x: x(p),
                stress: stress(p),
                mass: mass[material[p] as usize],
                deformation_gradient: deformation_gradient(p),
                plastic: Vec2::from_array(plastic[p]),
                material: material[p],
                ..*body
            };
        });
    }
    Ok(())
}

/// The arrays of what so many particles hold, compiled once for all layouts.
fn arrays_of_bodies<X: Dimensions>(count: usize, body: &dyn Fn(usize) -> Body<X>) -> Vec<Array> {
    vec![
        vectors::<X>("position", (0..count).map(|p| body(p).x)),
        matrices::<X>("stress", (0..count).map(|p| body(p).stress)),
        matrices::<X>("deformation_gradient", (0..count).map(|p| body(p).deformation_gradient)),
        Array::floats("plastic", (0..count).map(|p| body(p).plastic.to_array())),
        Array::whole("material", (0..count).map(|p| body(p).material).collect()),
    ]
}

impl<X: Dimensions, C: Carrier<X>, P: Layout<I>, G: Layout<X>> Medium for Continuum<X, C, P, G> {
    fn new(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Result<Self, String> {
        let fault = |error: allotrope::ShapeError| error.to_string();
        let mpm = Transfers::new(scene, setup);
        let mut points = Field::<C::Point, P>::try_new([particles.x.len()]).map_err(fault)?;
        for p in 0..particles.x.len() {
            points.set(p, C::point(&Body::of(setup, particles, p), &mpm));
        }
        let grid = grid::make(setup)?;
        let materials = setup.materials.iter().map(|material| material.model).collect();
        Ok(Self { points, grid, shape: grid::shape(setup), mpm, obstacles: Obstacles::new(setup), materials })
    }

    fn clear(&mut self) {
        // Of a sparse grid the blocks go back, and those are made anew that the particles touch.
        if G::SPARSE { self.grid.clear() } else { C::clear(&mut self.grid) }
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

    fn deforms(&self) -> bool {
        true
    }

    fn deform(&mut self) {
        C::deform(&mut self.points, &self.materials);
    }

    fn broken(&self) -> u32 {
        C::count_broken(&self.points, &self.mpm)
    }

    fn cell(&self, place: usize) -> IVec3 {
        node::<X>(self.mpm.stencil(C::body(&self.points.get(place), &self.mpm).x).base)
    }

    fn reorder(&mut self) -> Permutation {
        let (nodes, mpm) = (self.shape, self.mpm);
        self.points
            .reorder_by_key(|point| block_major(node::<X>(mpm.stencil(C::body(point, &mpm).x).base).as_uvec3(), nodes))
    }

    fn len(&self) -> usize {
        self.points.len()
    }

    fn particle(&self, place: usize) -> Particle {
        let body = C::body(&self.points.get(place), &self.mpm);
        let trace: f64 = (0..X::RANK).map(|axis| f64::from(body.stress.col(axis)[axis])).sum();
        let model = &self.materials[body.material as usize];
        Particle {
            x: triple::<X>(body.x),
            v: triple::<X>(body.v),
            c: rows::<X>(body.c),
            material: body.material,
            pressure: -trace / X::RANK as f64,
            elastic: f64::from(model.energy(body.deformation_gradient, body.plastic.to_array())),
        }
    }

    fn members(&self) -> Vec<Array> {
        let mut arrays = arrays_of_bodies(self.len(), &|p| C::body(&self.points.get(p), &self.mpm));
        arrays.extend(C::carried(self.len(), &|p| self.points.get(p)));
        arrays
    }

    fn set_members(&mut self, state: &State) -> Result<(), String> {
        let mut points = self.points.clone();
        C::set_carried(&mut points, state)?;
        set_bodies(
            state,
            self.len(),
            self.materials.len(),
            &|p| C::body(&self.points.get(p), &self.mpm),
            &mut |p, set| {
                let mut point = points.get(p);
                let mut body = C::body(&point, &self.mpm);
                set(&mut body);
                C::set_body(&mut point, &body);
                points.set(p, point);
            },
        )?;
        self.points = points;
        Ok(())
    }

    fn nodes(&self) -> Vec<Array> {
        let node = grid::nodes(&self.grid, self.shape);
        grid::arrays::<X>(self.shape, &|n| C::node(&node(n)))
    }

    fn grid_mass(&self) -> f64 {
        grid::sum(&self.grid, |node| f64::from(C::node(&node).1))
    }

    fn bytes(&self) -> usize {
        self.points.bytes() + self.grid.bytes()
    }

    fn memory_maps(&self) -> [MemoryMap<'_>; 2] {
        [self.points.memory_map(), self.grid.memory_map()]
    }
}
