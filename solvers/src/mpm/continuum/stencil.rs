//! The nodes around a particle, of a spline that is known when the program runs.

use allotrope::spatial::*;

use crate::Scene;
use crate::mpm::MpmSetup;
use crate::mpm::continuum::Constants;
use crate::mpm::convert::vector;

/// A scene's constants with those that are vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transfers<X: Spatial> {
    /// Those that are none.
    pub constants: Constants,
    /// In m/s^2.
    pub gravity: X::Vec<f32>,
}

/// The nodes around a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stencil<X: Spatial> {
    /// The first of them.
    pub base: X::Index,
    /// The particle's distance from it, in cells.
    fx: X::Vec<f32>,
    /// Of each node along an axis, the weights ..
    weights: [X::Vec<f32>; 4],
    /// .. and their derivatives.
    slopes: [X::Vec<f32>; 4],
}

impl<X: Spatial> Transfers<X> {
    /// The constants of a scene.
    pub fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        Self { constants: Constants::new(scene, setup), gravity: vector::<X, f32>(scene.gravity) }
    }

    /// The nodes around a place.
    #[inline(always)]
    pub fn stencil(&self, x: X::Vec<f32>) -> Stencil<X> {
        let xp = x * self.constants.inv_dx;
        // Rounded towards zero, which is down: no place is below the first node.
        let base = (xp - self.constants.reach()).to_index();
        let fx = xp - base.to_vec();
        let [weights, slopes] = self.constants.spline::<X>(fx);
        Stencil { base, fx, weights, slopes }
    }

    /// The offsets of the nodes of a stencil from its first, the last axis fastest.
    #[inline(always)]
    pub fn offsets(&self) -> impl Iterator<Item = X::Index> + use<X> {
        let width = self.constants.width;
        let count = width.pow(X::RANK as u32);
        let mut next = X::Index::default();
        (0..count).map(move |_| {
            let offset = next;
            for axis in (0..X::RANK).rev() {
                next[axis] += 1;
                if next[axis] < width {
                    break;
                }
                next[axis] = 0;
            }
            offset
        })
    }

    /// Where a node lies from the particle, in m.
    #[inline(always)]
    pub fn lever(&self, stencil: &Stencil<X>, offset: X::Index) -> X::Vec<f32> {
        (offset.to_vec::<f32>() - stencil.fx) * self.constants.dx
    }

    /// By what a node's force follows from the stress (with the sign of a gradient, and its unit, 1/m): the gradient of
    /// its weight, or what least squares makes of it (Hu et al. 2018, eq. 18).
    #[inline(always)]
    pub fn gradient(&self, stencil: &Stencil<X>, offset: X::Index) -> X::Vec<f32> {
        if self.constants.least_squares {
            self.lever(stencil, offset) * (stencil.weight(offset) * self.constants.inv_moment)
        } else {
            stencil.slope(offset) * self.constants.inv_dx
        }
    }

    /// Whether a particle of that velocity moves at most a cell a step; false for what is not a number.
    #[inline(always)]
    pub fn keeps_pace(&self, v: X::Vec<f32>) -> bool {
        (v * self.constants.dt).length_squared() <= self.constants.dx * self.constants.dx
    }
}

impl<X: Spatial> Stencil<X> {
    /// The weight of a node.
    #[inline(always)]
    pub fn weight(&self, offset: X::Index) -> f32 {
        X::Vec::<f32>::from_fn(|axis| self.weights[offset[axis] as usize][axis]).element_product()
    }

    /// The gradient of a node's weight, in 1/cells.
    #[inline(always)]
    fn slope(&self, offset: X::Index) -> X::Vec<f32> {
        X::Vec::<f32>::from_fn(|along| {
            let factor = |axis: usize| {
                let factors = if axis == along { &self.slopes } else { &self.weights };
                factors[offset[axis] as usize][axis]
            };
            X::Vec::<f32>::from_fn(factor).element_product()
        })
    }

    /// Polynomials along each axis that are orthogonal in the sum over the nodes of a quadratic spline, weighted by it:
    /// the constant, the place, and a square (Fu et al. 2017, section 4.2), at a node; and the sums of their squares.
    #[inline(always)]
    pub fn polynomials(&self, offset: X::Index) -> [[X::Vec<f32>; 3]; 2] {
        let (one, quarter) = (X::Vec::<f32>::splat(1.0), X::Vec::<f32>::splat(0.25));
        let third = self.over_nodes(|weight, at| weight * at * at * at);
        let square = |at: X::Vec<f32>| at * at - third * 4.0 * at - quarter;
        let norm = self.over_nodes(|weight, at| weight * square(at) * square(at));
        let here = offset.to_vec::<f32>() - self.fx;
        [[one, here, square(here)], [one, quarter, norm]]
    }

    /// The sum over the three nodes of a quadratic spline, along each axis, of what follows from a node's weight and its
    /// place from the particle in cells.
    #[inline(always)]
    fn over_nodes(&self, term: impl Fn(X::Vec<f32>, X::Vec<f32>) -> X::Vec<f32>) -> X::Vec<f32> {
        let term = |node: usize| term(self.weights[node], -self.fx + node as f32);
        term(0) + term(1) + term(2)
    }
}
