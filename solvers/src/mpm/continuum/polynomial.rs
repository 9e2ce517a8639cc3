//! PolyPIC (Fu et al. 2017) over quadratic splines: a particle carries a polynomial velocity field, up to one that
//! interpolates all of its nodes.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::{Dimensions, Node, PolynomialPoint, Stencil, Transfers};
use crate::mpm::materials::Model;

/// Scatters mass, momentum and the impulse of the stress of every point to its nodes.
#[kernel]
pub fn particle_to_grid<X: Dimensions>(
    points: &Field<PolynomialPoint<X>, _>,
    grid: &mut Field<Node<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mass = points.mass[p];
        let modes = points.modes[p];
        let impulse = points.stress[p] * mpm.constants.impulse;
        for offset in mpm.offsets() {
            let weight = stencil.weight(offset);
            let carried = velocity(&modes.as_ref()[..mpm.constants.modes], &stencil, offset);
            grid.v[stencil.base + offset] += carried * (weight * mass) + impulse * mpm.gradient(&stencil, offset);
            grid.m[stencil.base + offset] += weight * mass;
        }
    }
}

/// Gathers the velocity field from the nodes of every point, moves and deforms it.
#[kernel]
pub fn grid_to_particle<X: Dimensions>(
    points: &mut Field<PolynomialPoint<X>, _>,
    grid: &Field<Node<X>, _, X>,
    mpm: &Transfers<X>,
) {
    for p in points {
        let stencil = mpm.stencil(points.x[p]);
        let mut modes = X::Modes::default();
        let mut gradient = X::Mat::<f32>::zero();
        for offset in mpm.offsets() {
            let there = grid.v[stencil.base + offset];
            project(&mut modes.as_mut()[..mpm.constants.modes], &stencil, offset, there);
            gradient += X::Mat::<f32>::outer(there, mpm.gradient(&stencil, offset));
        }
        points.x[p] += modes.as_ref()[0] * mpm.constants.dt;
        points.modes[p] = modes;
        points.deformation_gradient[p] =
            (X::Mat::<f32>::identity() + gradient * mpm.constants.dt) * points.deformation_gradient[p];
    }
}

/// Lets the materials yield, and makes the stress.
#[kernel]
pub fn deform<X: Dimensions>(points: &mut Field<PolynomialPoint<X>, _>, materials: &[Model]) {
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
pub fn count_broken<X: Dimensions>(points: &Field<PolynomialPoint<X>, _>, mpm: &Transfers<X>) -> u32 {
    let mut broken = 0;
    for p in points {
        broken += u32::from(!mpm.keeps_pace(points.modes[p].as_ref()[0]));
    }
    broken
}

/// The velocity of a polynomial field at a node.
fn velocity<X: Dimensions>(modes: &[X::Vec<f32>], stencil: &Stencil<X>, offset: X::Index) -> X::Vec<f32> {
    let [values, _] = stencil.polynomials(offset);
    let mut v = X::Vec::<f32>::zero();
    for (&mode, powers) in modes.iter().zip(X::MODES) {
        v += mode * product::<X>(&values, powers);
    }
    v
}

/// Adds what a node's velocity says of each mode.
fn project<X: Dimensions>(modes: &mut [X::Vec<f32>], stencil: &Stencil<X>, offset: X::Index, there: X::Vec<f32>) {
    let [values, norms] = stencil.polynomials(offset);
    let weighted = there * stencil.weight(offset);
    for (mode, powers) in modes.iter_mut().zip(X::MODES) {
        *mode += weighted * (product::<X>(&values, powers) / product::<X>(&norms, powers));
    }
}

fn product<X: Spatial>(along: &[X::Vec<f32>; 3], powers: &[usize; 3]) -> f32 {
    X::Vec::<f32>::from_fn(|axis| along[powers[axis]][axis]).element_product()
}
