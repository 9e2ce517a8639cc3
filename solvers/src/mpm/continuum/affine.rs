//! APIC (Jiang et al. 2015): a particle carries a velocity and its gradient.

use allotrope::prelude::*;

use super::{AffinePoint, Matrix, Node, Nodes, Transfers, Vector, lowered, node, outer, raised};
use crate::mpm::materials::Model;
use crate::mpm::obstacles::Obstacles;

/// Empties the grid.
#[kernel]
pub fn clear(grid: &mut Field<Node, _, Nodes>) {
    for at in grid {
        grid[at] = Node { v: Vector::ZERO, m: 0.0 };
    }
}

/// Scatters mass, momentum and the impulse of the stress of every point to its nodes.
#[kernel]
pub fn particle_to_grid(points: &Field<AffinePoint, _>, grid: &mut Field<Node, _, Nodes>, mpm: &Transfers) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mass = points.mass[p];
        let momentum = mass * points.v[p];
        let affine = mass * points.c[p];
        let impulse = mpm.constants.impulse * points.stress[p];
        for offset in mpm.offsets() {
            let weight = stencil.weight(offset);
            let carried = momentum + affine * mpm.lever(&stencil, offset);
            grid.v[stencil.base + offset] += weight * carried + impulse * mpm.gradient(&stencil, offset);
            grid.m[stencil.base + offset] += weight * mass;
        }
    }
}

/// Makes momentum velocity, adds gravity, and heeds what stands in the way. Returns how many nodes move more than a cell a
/// step, or are not finite.
#[kernel]
pub fn update_grid(grid: &mut Field<Node, _, Nodes>, mpm: &Transfers, obstacles: &Obstacles) -> u32 {
    let mut broken = 0;
    for at in grid {
        let m = grid.m[at];
        if m > 0.0 {
            let v = grid.v[at] / m + mpm.constants.dt * mpm.gravity;
            let v = lowered(obstacles.meet(node(at), raised(v)));
            grid.v[at] = v;
            broken += u32::from(!mpm.keeps_pace(v));
        }
    }
    broken
}

/// Gathers velocity and its gradient from the nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle(points: &mut Field<AffinePoint, _>, grid: &Field<Node, _, Nodes>, mpm: &Transfers) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mut v = Vector::ZERO;
        let mut c = Matrix::ZERO;
        let mut gradient = Matrix::ZERO;
        for offset in mpm.offsets() {
            let there = grid.v[stencil.base + offset];
            let weighted = stencil.weight(offset) * there;
            v += weighted;
            c += outer(weighted, mpm.lever(&stencil, offset));
            gradient += outer(there, mpm.gradient(&stencil, offset));
        }
        points.v[p] = v;
        points.c[p] = mpm.constants.inv_moment * c;
        points.x[p] += mpm.constants.dt * v;
        points.deformation_gradient[p] =
            (Matrix::IDENTITY + mpm.constants.dt * gradient) * points.deformation_gradient[p];
    }
}

/// Lets the materials yield, and makes the stress.
#[kernel]
pub fn deform(points: &mut Field<AffinePoint, _>, materials: &[Model]) {
    for p in points {
        let model = materials[points.material[p] as usize];
        let updated = model.update(points.deformation_gradient[p], points.plastic[p].to_array());
        points.deformation_gradient[p] = updated.deformation_gradient;
        points.plastic[p] = Vec2::from_array(updated.plastic);
        points.stress[p] = updated.kirchhoff_stress;
    }
}

/// How many points moved more than a cell in the last step, or are not finite.
#[kernel]
pub fn count_broken(points: &Field<AffinePoint, _>, mpm: &Transfers) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.v[p]));
    }
    broken
}
