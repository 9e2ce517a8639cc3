//! The step of the fluid in space.

use allotrope::prelude::*;

use super::parameters::{Mpm, quadratic_weights};
use super::records::{Node3, Point3};

/// Empties the grid.
#[kernel]
pub fn clear(grid: &mut Field<Node3, _, Ijk>) {
    for ijk in grid {
        grid[ijk] = Node3 { v: Vec3::ZERO, m: 0.0 };
    }
}

/// Scatters mass and momentum of every point to its 3 x 3 x 3 nodes.
#[kernel]
pub fn particle_to_grid(points: &Field<Point3, _>, grid: &mut Field<Node3, _, Ijk>, mpm: &Mpm<Vec3>) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - 0.5).as_ivec3();
        let fx = xp - base.as_vec3();
        let w = quadratic_weights(fx);
        let momentum = mpm.mass * points.v[p];
        let affine = mpm.stress(points.j[p]) + mpm.mass * points.c[p];
        for (i, j, k) in unroll!(0..3, 0..3, 0..3) {
            let offset = ivec3(i, j, k);
            let dpos = (offset.as_vec3() - fx) * mpm.dx;
            let weight = w[i as usize].x * w[j as usize].y * w[k as usize].z;
            grid.v[base + offset] += weight * (momentum + affine * dpos);
            grid.m[base + offset] += weight * mpm.mass;
        }
    }
}

/// Makes momentum velocity, adds gravity, and lets nothing flow out through the walls. Returns how many nodes move more
/// than a cell a step, or are not finite: a particle's velocity is a mean of its nodes', so that as long as there are
/// none, all particles are sound.
#[kernel]
pub fn update_grid(grid: &mut Field<Node3, _, Ijk>, mpm: &Mpm<Vec3>) -> u32 {
    let mut broken = 0;
    for (i, j, k) in grid {
        let m = grid.m[(i, j, k)];
        if m > 0.0 {
            let v = mpm.slip(ivec3(i, j, k), grid.v[(i, j, k)] / m + mpm.dt * mpm.gravity);
            grid.v[(i, j, k)] = v;
            broken += u32::from(!mpm.keeps_pace(v));
        }
    }
    broken
}

/// Gathers velocity and its gradient from the 3 x 3 x 3 nodes of every point, and moves it.
#[kernel]
pub fn grid_to_particle(points: &mut Field<Point3, _>, grid: &Field<Node3, _, Ijk>, mpm: &Mpm<Vec3>) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - 0.5).as_ivec3();
        let fx = xp - base.as_vec3();
        let w = quadratic_weights(fx);
        let mut v = Vec3::ZERO;
        let mut c = Mat3::ZERO;
        for (i, j, k) in unroll!(0..3, 0..3, 0..3) {
            let offset = ivec3(i, j, k);
            let dpos = offset.as_vec3() - fx;
            let weighted = w[i as usize].x * w[j as usize].y * w[k as usize].z * grid.v[base + offset];
            v += weighted;
            c += Mat3::from_cols(weighted * dpos.x, weighted * dpos.y, weighted * dpos.z);
        }
        let c = 4.0 * mpm.inv_dx * c;
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += mpm.dt * v;
        points.j[p] *= 1.0 + mpm.dt * (c.x_axis.x + c.y_axis.y + c.z_axis.z);
    }
}

/// How many points moved more than a cell in the last step, or are not finite.
#[kernel]
pub fn count_broken(points: &Field<Point3, _>, mpm: &Mpm<Vec3>) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.v[p]));
    }
    broken
}
