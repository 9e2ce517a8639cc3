//! The nodes around a particle, of a spline that is known when the program runs.

use super::{DIMENSIONS, Index, Vector, vector};
use crate::Scene;
use crate::mpm::continuum::Constants;

/// A scene's constants with those that are vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transfers {
    /// Those that are none.
    pub constants: Constants,
    /// In m/s^2.
    pub gravity: Vector,
}

/// The nodes around a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stencil {
    /// The first of them.
    pub base: Index,
    /// The particle's distance from it, in cells.
    fx: Vector,
    /// Along each axis, the weights ..
    weights: [[f32; 4]; DIMENSIONS],
    /// .. and their derivatives.
    slopes: [[f32; 4]; DIMENSIONS],
}

impl Transfers {
    /// The constants of a scene.
    pub fn new(scene: &Scene) -> Self {
        Self { constants: Constants::new(scene), gravity: vector(scene.gravity) }
    }

    /// The nodes around a place.
    #[inline(always)]
    pub fn stencil(&self, x: Vector) -> Stencil {
        let xp = x * self.constants.inv_dx;
        // Rounded towards zero, which is down: no place is below the first node.
        let below = (xp - self.constants.reach()).to_array().map(|place| place as i32);
        let base = Index::from_array(below);
        let fx = xp - Vector::from_array(below.map(|place| place as f32));
        let axes = fx.to_array().map(|fx| self.constants.spline(fx));
        Stencil { base, fx, weights: axes.map(|(weights, _)| weights), slopes: axes.map(|(_, slopes)| slopes) }
    }

    /// The offsets of the nodes of a stencil from its first, the last axis fastest.
    #[inline(always)]
    pub fn offsets(&self) -> impl Iterator<Item = Index> + use<> {
        let width = self.constants.width;
        let count = width.pow(DIMENSIONS as u32);
        let mut next = [0; DIMENSIONS];
        (0..count).map(move |_| {
            let offset = Index::from_array(next);
            for axis in (0..DIMENSIONS).rev() {
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
    pub fn lever(&self, stencil: &Stencil, offset: Index) -> Vector {
        (stencil.steps(offset) - stencil.fx) * self.constants.dx
    }

    /// By what a node's force follows from the stress (with the sign of a gradient, and its unit, 1/m): the gradient of
    /// its weight, or what least squares makes of it (Hu et al. 2018, eq. 18).
    #[inline(always)]
    pub fn gradient(&self, stencil: &Stencil, offset: Index) -> Vector {
        if self.constants.least_squares {
            stencil.weight(offset) * self.constants.inv_moment * self.lever(stencil, offset)
        } else {
            stencil.slope(offset) * self.constants.inv_dx
        }
    }

    /// Whether a particle of that velocity moves at most a cell a step; false for what is not a number.
    #[inline(always)]
    pub fn keeps_pace(&self, v: Vector) -> bool {
        (v * self.constants.dt).length_squared() <= self.constants.dx * self.constants.dx
    }
}

impl Stencil {
    #[inline(always)]
    fn steps(&self, offset: Index) -> Vector {
        Vector::from_array(offset.to_array().map(|steps| steps as f32))
    }

    /// The weight of a node.
    #[inline(always)]
    pub fn weight(&self, offset: Index) -> f32 {
        let offset = offset.to_array();
        (0..DIMENSIONS).map(|axis| self.weights[axis][offset[axis] as usize]).product()
    }

    /// The gradient of a node's weight, in 1/cells.
    #[inline(always)]
    fn slope(&self, offset: Index) -> Vector {
        let offset = offset.to_array();
        Vector::from_array(std::array::from_fn(|along| {
            (0..DIMENSIONS)
                .map(|axis| {
                    let factors = if axis == along { &self.slopes[axis] } else { &self.weights[axis] };
                    factors[offset[axis] as usize]
                })
                .product()
        }))
    }

    /// Polynomials along each axis that are orthogonal in the sum over the nodes of a quadratic spline, weighted by it:
    /// the constant, the place, and a square (Fu et al. 2017, section 4.2), at a node; and the sums of their squares.
    #[inline(always)]
    pub fn polynomials(&self, offset: Index) -> ([[f32; 3]; DIMENSIONS], [[f32; 3]; DIMENSIONS]) {
        let (fx, offset) = (self.fx.to_array(), offset.to_array());
        let along: [([f32; 3], [f32; 3]); DIMENSIONS] = std::array::from_fn(|axis| {
            let weights = &self.weights[axis];
            let at = |n: usize| n as f32 - fx[axis];
            let third: f32 = (0..3).map(|n| weights[n] * at(n) * at(n) * at(n)).sum();
            let square = |n: usize| at(n) * at(n) - 4.0 * third * at(n) - 0.25;
            let norm: f32 = (0..3).map(|n| weights[n] * square(n) * square(n)).sum();
            let here = offset[axis] as usize;
            ([1.0, at(here), square(here)], [1.0, 0.25, norm])
        });
        (along.map(|(values, _)| values), along.map(|(_, norms)| norms))
    }
}
