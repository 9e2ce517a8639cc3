//! PolyPIC (Fu et al. 2017) over quadratic splines: a particle carries a polynomial velocity field, up to one that
//! interpolates all of its nodes.

use allotrope::prelude::*;

use super::{DIMENSIONS, MODES, Matrix, Modes, Node, Nodes, PolynomialPoint, Stencil, Transfers, Vector, outer};
use crate::mpm::materials::Model;

/// Scatters mass, momentum and the impulse of the stress of every point to its nodes.
#[kernel]
pub fn particle_to_grid(points: &Field<PolynomialPoint, _>, grid: &mut Field<Node, _, Nodes>, mpm: &Transfers) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mass = points.mass[p];
        let modes = points.modes[p];
        let impulse = mpm.constants.impulse * points.stress[p];
        for offset in mpm.offsets() {
            let weight = stencil.weight(offset);
            let carried = velocity(&modes[..mpm.constants.modes], &stencil, offset);
            grid.v[stencil.base + offset] += weight * mass * carried + impulse * mpm.gradient(&stencil, offset);
            grid.m[stencil.base + offset] += weight * mass;
        }
    }
}

/// Gathers the velocity field from the nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle(points: &mut Field<PolynomialPoint, _>, grid: &Field<Node, _, Nodes>, mpm: &Transfers) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mut modes: Modes = [Vector::ZERO; MODES.len()];
        let mut gradient = Matrix::ZERO;
        for offset in mpm.offsets() {
            let there = grid.v[stencil.base + offset];
            project(&mut modes[..mpm.constants.modes], &stencil, offset, there);
            gradient += outer(there, mpm.gradient(&stencil, offset));
        }
        points.x[p] += mpm.constants.dt * modes[0];
        points.modes[p] = modes;
        points.deformation_gradient[p] =
            (Matrix::IDENTITY + mpm.constants.dt * gradient) * points.deformation_gradient[p];
    }
}

/// Lets the materials yield, and makes the stress.
#[kernel]
pub fn deform(points: &mut Field<PolynomialPoint, _>, materials: &[Model]) {
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
pub fn count_broken(points: &Field<PolynomialPoint, _>, mpm: &Transfers) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.modes[p][0]));
    }
    broken
}

/// The velocity of a polynomial field at a node.
fn velocity(modes: &[Vector], stencil: &Stencil, offset: super::Index) -> Vector {
    let (values, _) = stencil.polynomials(offset);
    modes.iter().zip(MODES).map(|(&mode, powers)| product(&values, powers) * mode).sum()
}

/// Adds what a node's velocity says of each mode.
fn project(modes: &mut [Vector], stencil: &Stencil, offset: super::Index, there: Vector) {
    let (values, norms) = stencil.polynomials(offset);
    let weighted = stencil.weight(offset) * there;
    for (mode, powers) in modes.iter_mut().zip(MODES) {
        *mode += product(&values, powers) / product(&norms, powers) * weighted;
    }
}

fn product(along: &[[f32; 3]; DIMENSIONS], powers: [usize; DIMENSIONS]) -> f32 {
    along.iter().zip(powers).map(|(values, power)| values[power]).product()
}
