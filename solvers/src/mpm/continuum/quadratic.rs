//! APIC and least squares over quadratic splines, the usual choice: loops over the nodes, three along each axis, are
//! unrolled.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::{AffinePoint, Node, Transfers};
use crate::mpm::fluid::{quadratic_weights, weight};

/// Scatters mass, momentum and the impulse of the stress of every point to its nodes.
#[kernel]
pub fn particle_to_grid<X: Spatial>(
    points: &Field<AffinePoint<X>, _>,
    grid: &mut Field<Node<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let xp = points.x[p] * mpm.constants.inv_dx;
        let base = (xp - 0.5).to_index();
        let fx = xp - base.to_vec();
        let w = quadratic_weights::<X, f32>(fx);
        let mass = points.mass[p];
        let momentum = points.v[p] * mass;
        let affine = points.stress[p] * (mpm.constants.impulse * mpm.constants.inv_moment) + points.c[p] * mass;
        for offset in unroll!(X, 0..3) {
            let dpos = (offset.to_vec::<f32>() - fx) * mpm.constants.dx;
            let weight = weight::<X, f32>(&w, offset);
            grid.v[base + offset] += (momentum + affine * dpos) * weight;
            grid.m[base + offset] += weight * mass;
        }
    }
}

/// Gathers velocity and its gradient from the nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle<X: Spatial>(
    points: &mut Field<AffinePoint<X>, _>,
    grid: &Field<Node<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let xp = points.x[p] * mpm.constants.inv_dx;
        let base = (xp - 0.5).to_index();
        let fx = xp - base.to_vec();
        let w = quadratic_weights::<X, f32>(fx);
        let mut v = X::Vec::<f32>::zero();
        let mut c = X::Mat::<f32>::zero();
        for offset in unroll!(X, 0..3) {
            let dpos = offset.to_vec::<f32>() - fx;
            let weighted = grid.v[base + offset] * weight::<X, f32>(&w, offset);
            v += weighted;
            c += X::Mat::<f32>::outer(weighted, dpos);
        }
        let c = c * (4.0 * mpm.constants.inv_dx);
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += v * mpm.constants.dt;
        points.deformation_gradient[p] =
            (X::Mat::<f32>::identity() + c * mpm.constants.dt) * points.deformation_gradient[p];
    }
}
