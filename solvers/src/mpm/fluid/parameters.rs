//! What the kernels know of a scene, and the formulas that they share.

use allotrope::spatial::*;

use crate::Scene;
use crate::mpm::MpmSetup;
use crate::mpm::convert::vector;

/// A fluid's constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mpm<X: Spatial, T: Real = f32> {
    /// Side of a cell in m.
    pub dx: T,
    /// One over it.
    pub inv_dx: T,
    /// Seconds a step.
    pub dt: T,
    /// Mass of a particle in kg.
    pub mass: T,
    /// `-4 dt E V / dx^2` with the stiffness `E` and the particle's volume `V`: times `j - 1`, what pressure adds in a
    /// step to the affine momentum (Hu et al. 2018, "A moving least squares material point method", eq. 29, with `D =
    /// dx^2 / 4`).
    pub pressure: T,
    /// Bulk modulus in Pa.
    pub stiffness: T,
    /// In m/s^2.
    pub gravity: X::Vec<T>,
    /// Nodes below this belong to the lower walls.
    pub wall: i32,
    /// Nodes above this, on each axis, belong to the upper walls.
    pub inner: X::Index,
}

impl<X: Spatial, T: Real> Mpm<X, T> {
    /// The constants of a scene.
    pub fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        let (dx, wall) = (setup.dx(), setup.wall as i32);
        let volume = setup.particle_volume();
        let material = &setup.materials[0];
        let stiffness = material.model.wave_modulus();
        Self {
            dx: T::from_f64(dx),
            inv_dx: T::from_f64(1.0 / dx),
            dt: T::from_f64(scene.dt),
            mass: T::from_f64(volume * material.density),
            pressure: T::from_f64(-4.0 * scene.dt * stiffness * volume / (dx * dx)),
            stiffness: T::from_f64(stiffness),
            gravity: vector::<X, T>(scene.gravity),
            wall,
            inner: X::Index::from_fn(|axis| setup.grid[axis] as i32 - wall),
        }
    }

    /// Pressure in Pa and energy density in J/m^3 of a particle of that volume ratio.
    pub fn of_volume(&self, j: T) -> (f64, f64) {
        let (stiffness, compression) = (self.stiffness.to_f64(), 1.0 - j.to_f64());
        (stiffness * compression, 0.5 * stiffness * compression * compression)
    }

    /// What a particle of that volume ratio spreads as affine momentum by its pressure, per metre.
    #[inline(always)]
    pub fn stress(&self, j: T) -> X::Mat<T> {
        X::Mat::<T>::from_diagonal(X::Vec::<T>::from_fn(|_axis| self.pressure * (j - T::ONE)))
    }

    /// The velocity at a node without what points outwards at a wall.
    #[inline(always)]
    pub fn slip(&self, node: X::Index, v: X::Vec<T>) -> X::Vec<T> {
        let zero = X::Vec::<T>::zero();
        let inwards = v.max(zero);
        let v = X::Vec::<T>::from_fn(|axis| if node[axis] < self.wall { inwards[axis] } else { v[axis] });
        let inwards = v.min(zero);
        X::Vec::<T>::from_fn(|axis| if node[axis] > self.inner[axis] { inwards[axis] } else { v[axis] })
    }

    /// Whether a particle of that velocity moves at most a cell a step; false for what is not a number.
    #[inline(always)]
    pub fn keeps_pace(&self, v: X::Vec<T>) -> bool {
        (v * self.dt).length_squared() <= self.dx * self.dx
    }
}

/// The quadratic B-spline weights of the three nodes along each axis, where `fx` is the distance from the first of them
/// in cells, from 0.5 to 1.5 (Steffen, Kirby & Berzins 2008; MPM course of SIGGRAPH 2016, eq. 123).
#[inline(always)]
pub fn quadratic_weights<X: Spatial, T: Real>(fx: X::Vec<T>) -> [X::Vec<T>; 3] {
    let half = T::from(0.5);
    let (first, middle, last) = (-fx + T::from(1.5), fx - T::ONE, fx - half);
    [first * first * half, -(middle * middle) + T::from(0.75), last * last * half]
}

/// The weight of a node: the product of its weights along all axes.
#[inline(always)]
pub fn weight<X: Spatial, T: Real>(weights: &[X::Vec<T>; 3], offset: X::Index) -> T {
    X::Vec::<T>::from_fn(|axis| weights[offset[axis] as usize][axis]).element_product()
}
