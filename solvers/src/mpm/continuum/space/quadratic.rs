//! APIC and least squares over quadratic splines, the usual choice: loops over the 3 x 3 x 3 nodes are unrolled.

use allotrope::prelude::*;

use super::{AffinePoint, Node, Transfers};
use crate::mpm::fluid::quadratic_weights;

/// Scatters mass, momentum and the impulse of the stress of every point to its 3 x 3 x 3 nodes.
#[kernel]
pub fn particle_to_grid(points: &Field<AffinePoint, _>, grid: &mut Field<Node, _, Ijk>, mpm: &Transfers) {
    for p in points {
        let xp = points.x[p] * mpm.constants.inv_dx;
        let base = (xp - 0.5).as_ivec3();
        let fx = xp - base.as_vec3();
        let w = quadratic_weights::<Ijk, f32>(fx);
        let mass = points.mass[p];
        let momentum = mass * points.v[p];
        let affine = mpm.constants.impulse * mpm.constants.inv_moment * points.stress[p] + mass * points.c[p];
        for (i, j, k) in unroll!(0..3, 0..3, 0..3) {
            let offset = ivec3(i, j, k);
            let dpos = (offset.as_vec3() - fx) * mpm.constants.dx;
            let weight = w[i as usize].x * w[j as usize].y * w[k as usize].z;
            grid.v[base + offset] += weight * (momentum + affine * dpos);
            grid.m[base + offset] += weight * mass;
        }
    }
}

/// Gathers velocity and its gradient from the 3 x 3 x 3 nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle(points: &mut Field<AffinePoint, _>, grid: &Field<Node, _, Ijk>, mpm: &Transfers) {
    for p in points {
        let xp = points.x[p] * mpm.constants.inv_dx;
        let base = (xp - 0.5).as_ivec3();
        let fx = xp - base.as_vec3();
        let w = quadratic_weights::<Ijk, f32>(fx);
        let mut v = Vec3::ZERO;
        let mut c = Mat3::ZERO;
        for (i, j, k) in unroll!(0..3, 0..3, 0..3) {
            let offset = ivec3(i, j, k);
            let dpos = offset.as_vec3() - fx;
            let weighted = w[i as usize].x * w[j as usize].y * w[k as usize].z * grid.v[base + offset];
            v += weighted;
            c += Mat3::from_cols(weighted * dpos.x, weighted * dpos.y, weighted * dpos.z);
        }
        let c = 4.0 * mpm.constants.inv_dx * c;
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += mpm.constants.dt * v;
        points.deformation_gradient[p] = (Mat3::IDENTITY + mpm.constants.dt * c) * points.deformation_gradient[p];
    }
}
