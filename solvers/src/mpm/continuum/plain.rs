//! PIC (Harlow 1964) and FLIP (Brackbill & Ruppel 1986): a particle carries a velocity, and takes from the grid a blend
//! of its velocity and its change.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::{ChangingNode, Dimensions, PlainPoint, Transfers};
use crate::mpm::convert::{lowered, node, raised};
use crate::mpm::materials::Model;
use crate::mpm::obstacles::Obstacles;

/// Empties the grid.
#[kernel]
pub fn clear<X: Spatial>(grid: &mut Field<ChangingNode<X>, _, X>) {
    for at in grid {
        grid[at] = ChangingNode { v: X::Vec::<f32>::zero(), before: X::Vec::<f32>::zero(), m: 0.0 };
    }
}

/// Scatters mass, momentum and the impulse of the stress of every point to its nodes.
#[kernel]
pub fn particle_to_grid<X: Spatial>(
    points: &Field<PlainPoint<X>, _>,
    grid: &mut Field<ChangingNode<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mass = points.mass[p];
        let momentum = points.v[p] * mass;
        let impulse = points.stress[p] * mpm.constants.impulse;
        for offset in mpm.offsets() {
            let weight = stencil.weight(offset);
            grid.before[stencil.base + offset] += momentum * weight;
            grid.v[stencil.base + offset] += momentum * weight + impulse * mpm.gradient(&stencil, offset);
            grid.m[stencil.base + offset] += weight * mass;
        }
    }
}

/// Makes momentum velocity, adds gravity, and heeds what stands in the way. Returns how many nodes move more than a cell a
/// step, or are not finite.
#[kernel]
pub fn update_grid<X: Spatial>(
    grid: &mut Field<ChangingNode<X>, _, X>,
    mpm: &Transfers<X>,
    obstacles: &Obstacles,
) -> u32 {
    let mut broken = 0;
    for at in grid {
        let m = grid.m[at];
        if m > 0.0 {
            let v = grid.v[at] / m + mpm.gravity * mpm.constants.dt;
            let v = lowered::<X>(obstacles.meet(node::<X>(at), raised::<X>(v)));
            grid.v[at] = v;
            grid.before[at] /= m;
            broken += u32::from(!mpm.keeps_pace(v));
        }
    }
    broken
}

/// Gathers velocity from the nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle<X: Spatial>(
    points: &mut Field<PlainPoint<X>, _>,
    grid: &Field<ChangingNode<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mut v = X::Vec::<f32>::zero();
        let mut change = X::Vec::<f32>::zero();
        let mut gradient = X::Mat::<f32>::zero();
        for offset in mpm.offsets() {
            let there = grid.v[stencil.base + offset];
            let weight = stencil.weight(offset);
            v += there * weight;
            change += (there - grid.before[stencil.base + offset]) * weight;
            gradient += X::Mat::<f32>::outer(there, mpm.gradient(&stencil, offset));
        }
        points.x[p] += v * mpm.constants.dt;
        points.v[p] = (points.v[p] + change) * mpm.constants.blend + v * (1.0 - mpm.constants.blend);
        points.deformation_gradient[p] =
            (X::Mat::<f32>::identity() + gradient * mpm.constants.dt) * points.deformation_gradient[p];
    }
}

/// Lets the materials yield, and makes the stress.
#[kernel]
pub fn deform<X: Dimensions>(points: &mut Field<PlainPoint<X>, _>, materials: &[Model]) {
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
pub fn count_broken<X: Spatial>(points: &Field<PlainPoint<X>, _>, mpm: &Transfers<X>) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.v[p]));
    }
    broken
}
