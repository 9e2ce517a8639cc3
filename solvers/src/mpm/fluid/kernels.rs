//! The step of the fluid, in a plane and in space, in single and double precision.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::parameters::{Mpm, quadratic_weights, weight};
use super::records::{Node, Point};

/// Empties the grid.
#[kernel]
pub fn clear<X: Spatial, T: Real>(grid: &mut Field<Node<X, T>, _, X>) {
    for at in grid {
        grid[at] = Node { v: X::Vec::<T>::zero(), m: T::ZERO };
    }
}

/// Scatters mass and momentum of every point to its nodes, three along each axis.
#[kernel]
pub fn particle_to_grid<X: Spatial, T: Real>(
    points: &Field<Point<X, T>, _>,
    grid: &mut Field<Node<X, T>, _, X>,
    mpm: &Mpm<X, T>,
) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - T::from(0.5)).to_index();
        let fx = xp - base.to_vec();
        let w = quadratic_weights::<X, T>(fx);
        let momentum = points.v[p] * mpm.mass;
        let affine = mpm.stress(points.j[p]) + points.c[p] * mpm.mass;
        for offset in unroll!(X, 0..3) {
            let dpos = (offset.to_vec::<T>() - fx) * mpm.dx;
            let weight = weight::<X, T>(&w, offset);
            grid.v[base + offset] += (momentum + affine * dpos) * weight;
            grid.m[base + offset] += weight * mpm.mass;
        }
    }
}

/// Makes momentum velocity, adds gravity, and lets nothing flow out through the walls. Returns how many nodes move more
/// than a cell a step, or are not finite: a particle's velocity is a mean of its nodes', so that as long as there are
/// none, all particles are sound.
#[kernel]
pub fn update_grid<X: Spatial, T: Real>(grid: &mut Field<Node<X, T>, _, X>, mpm: &Mpm<X, T>) -> u32 {
    let mut broken = 0;
    for at in grid {
        let m = grid.m[at];
        if m > T::ZERO {
            let v = mpm.slip(at, grid.v[at] / m + mpm.gravity * mpm.dt);
            grid.v[at] = v;
            broken += u32::from(!mpm.keeps_pace(v));
        }
    }
    broken
}

/// Gathers velocity and its gradient from the nodes of every point, and moves it.
#[kernel]
pub fn grid_to_particle<X: Spatial, T: Real>(
    points: &mut Field<Point<X, T>, _>,
    grid: &Field<Node<X, T>, _, X>,
    mpm: &Mpm<X, T>,
) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - T::from(0.5)).to_index();
        let fx = xp - base.to_vec();
        let w = quadratic_weights::<X, T>(fx);
        let mut v = X::Vec::<T>::zero();
        let mut c = X::Mat::<T>::zero();
        for offset in unroll!(X, 0..3) {
            let dpos = offset.to_vec::<T>() - fx;
            let weighted = grid.v[base + offset] * weight::<X, T>(&w, offset);
            v += weighted;
            c += X::Mat::<T>::outer(weighted, dpos);
        }
        let c = c * (T::from(4.0) * mpm.inv_dx);
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += v * mpm.dt;
        points.j[p] *= T::ONE + mpm.dt * c.trace();
    }
}

/// How many points moved more than a cell in the last step, or are not finite.
#[kernel]
pub fn count_broken<X: Spatial, T: Real>(points: &Field<Point<X, T>, _>, mpm: &Mpm<X, T>) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.v[p]));
    }
    broken
}
