//! What the kernels know of a scene, and the formulas that they share.

use std::ops::{Mul, Sub};

use allotrope::prelude::*;

use crate::scene::Scene;

/// A fluid's constants in `V`, [`Vec2`] or [`Vec3`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mpm<V> {
    /// Side of a cell in m.
    pub dx: f32,
    /// One over it.
    pub inv_dx: f32,
    /// Seconds a step.
    pub dt: f32,
    /// Mass of a particle in kg.
    pub mass: f32,
    /// `-4 dt E V / dx^2` with the stiffness `E` and the particle's volume `V`: times `j - 1`, what pressure adds in a
    /// step to the affine momentum (Hu et al. 2018, "A moving least squares material point method", eq. 29, with `D =
    /// dx^2 / 4`).
    pub pressure: f32,
    /// Bulk modulus in Pa.
    pub stiffness: f32,
    /// In m/s^2.
    pub gravity: V,
    /// Nodes below this belong to the lower walls.
    pub wall: i32,
    /// Nodes above this, on each axis, belong to the upper walls.
    pub inner: [i32; 3],
}

impl<V> Mpm<V> {
    fn new(scene: &Scene, gravity: V) -> Self {
        let (dx, wall) = (scene.dx(), scene.wall as i32);
        let volume = scene.particle_volume();
        let material = &scene.materials[0];
        let stiffness = material.model.wave_modulus();
        Self {
            dx: dx as f32,
            inv_dx: (1.0 / dx) as f32,
            dt: scene.dt as f32,
            mass: (volume * material.density) as f32,
            pressure: (-4.0 * scene.dt * stiffness * volume / (dx * dx)) as f32,
            stiffness: stiffness as f32,
            gravity,
            wall,
            inner: scene.grid.map(|nodes| nodes as i32 - wall),
        }
    }
}

impl<V> Mpm<V> {
    /// Pressure in Pa and energy density in J/m^3 of a particle of that volume ratio.
    pub fn of_volume(&self, j: f32) -> (f64, f64) {
        let (stiffness, compression) = (f64::from(self.stiffness), 1.0 - f64::from(j));
        (stiffness * compression, 0.5 * stiffness * compression * compression)
    }
}

impl Mpm<Vec2> {
    /// The constants of a scene in the plane.
    pub fn plane(scene: &Scene) -> Self {
        let [x, y, _] = scene.gravity;
        Self::new(scene, vec2(x as f32, y as f32))
    }

    /// What a particle of that volume ratio spreads as affine momentum by its pressure, per metre.
    #[inline(always)]
    pub fn stress(&self, j: f32) -> Mat2 {
        Mat2::from_diagonal(Vec2::splat(self.pressure * (j - 1.0)))
    }

    /// The velocity at a node without what points outwards at a wall.
    #[inline(always)]
    pub fn slip(&self, node: IVec2, v: Vec2) -> Vec2 {
        let [i, j, _] = self.inner;
        let v = Vec2::select(node.cmplt(IVec2::splat(self.wall)), v.max(Vec2::ZERO), v);
        Vec2::select(node.cmpgt(ivec2(i, j)), v.min(Vec2::ZERO), v)
    }

    /// Whether a particle of that velocity moves at most a cell a step; false for what is not a number.
    #[inline(always)]
    pub fn keeps_pace(&self, v: Vec2) -> bool {
        (v * self.dt).length_squared() <= self.dx * self.dx
    }
}

impl Mpm<Vec3> {
    /// The constants of a scene in space.
    pub fn space(scene: &Scene) -> Self {
        let [x, y, z] = scene.gravity;
        Self::new(scene, vec3(x as f32, y as f32, z as f32))
    }

    /// What a particle of that volume ratio spreads as affine momentum by its pressure, per metre.
    #[inline(always)]
    pub fn stress(&self, j: f32) -> Mat3 {
        Mat3::from_diagonal(Vec3::splat(self.pressure * (j - 1.0)))
    }

    /// The velocity at a node without what points outwards at a wall.
    #[inline(always)]
    pub fn slip(&self, node: IVec3, v: Vec3) -> Vec3 {
        let v = Vec3::select(node.cmplt(IVec3::splat(self.wall)), v.max(Vec3::ZERO), v);
        Vec3::select(node.cmpgt(IVec3::from_array(self.inner)), v.min(Vec3::ZERO), v)
    }

    /// Whether a particle of that velocity moves at most a cell a step; false for what is not a number.
    #[inline(always)]
    pub fn keeps_pace(&self, v: Vec3) -> bool {
        (v * self.dt).length_squared() <= self.dx * self.dx
    }
}

/// The quadratic B-spline weights of the three nodes along each axis, where `fx` is the distance from the first of them
/// in cells, from 0.5 to 1.5 (Steffen, Kirby & Berzins 2008; MPM course of SIGGRAPH 2016, eq. 123).
#[inline(always)]
pub fn quadratic_weights<V>(fx: V) -> [V; 3]
where
    V: Copy + Mul<Output = V> + Sub<f32, Output = V>,
    f32: Sub<V, Output = V> + Mul<V, Output = V>,
{
    let (first, middle, last) = (1.5 - fx, fx - 1.0, fx - 0.5);
    [0.5 * (first * first), 0.75 - middle * middle, 0.5 * (last * last)]
}
