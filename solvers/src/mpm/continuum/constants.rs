//! What the kernels need to know of a scene, whatever its dimensions.

use allotrope::spatial::*;

use crate::Scene;
use crate::mpm::{Forces, MpmSetup, Scheme};

/// A scene's constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Side of a cell in m.
    pub dx: f32,
    /// One over it.
    pub inv_dx: f32,
    /// Seconds a step.
    pub dt: f32,
    /// `-dt V` with a particle's volume at rest `V`: what its Kirchhoff stress is multiplied by to become momentum.
    pub impulse: f32,
    /// Nodes an axis that a particle meets: 2, 3 or 4.
    pub width: i32,
    /// One over the second moment of the weights along an axis: `4 / dx^2` of quadratic splines, `3 / dx^2` of cubic ones
    /// (Jiang et al. 2016, section 5.3). Of linear ones it depends on the place, and is zero here.
    pub inv_moment: f32,
    /// Whether forces come from least squares, not from the gradients of weights.
    pub least_squares: bool,
    /// The share of FLIP.
    pub blend: f32,
    /// Modes of PolyPIC.
    pub modes: usize,
}

impl Constants {
    /// The constants of a scene.
    pub fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        let dx = setup.dx();
        let width = setup.transfer.spline.width();
        let (blend, modes) = match setup.transfer.scheme {
            Scheme::Flip { blend } => (blend, 0),
            Scheme::PolyPic { modes } => (0.0, modes),
            Scheme::Pic | Scheme::Apic => (0.0, 0),
        };
        let inv_moment = match width {
            3 => 4.0,
            4 => 3.0,
            _ => 0.0,
        };
        Self {
            dx: dx as f32,
            inv_dx: (1.0 / dx) as f32,
            dt: scene.dt as f32,
            impulse: (-scene.dt * setup.particle_volume()) as f32,
            width: width as i32,
            inv_moment: (inv_moment / (dx * dx)) as f32,
            least_squares: setup.transfer.forces == Forces::LeastSquares,
            blend: blend as f32,
            modes,
        }
    }

    /// Whether the spline is quadratic and forces come from least squares.
    pub fn is_usual(&self) -> bool {
        self.width == 3 && self.least_squares
    }

    /// Weights of the nodes along each axis, and their derivatives by the particle's place in cells, where `fx` is the
    /// distance from the first of them in cells (Jiang et al. 2016, eq. 122 to 124).
    #[inline(always)]
    pub fn spline<X: Spatial>(&self, fx: X::Vec<f32>) -> [[X::Vec<f32>; 4]; 2] {
        let (zero, one) = (X::Vec::<f32>::splat(0.0), X::Vec::<f32>::splat(1.0));
        match self.width {
            2 => [[one - fx, fx, zero, zero], [-one, one, zero, zero]],
            3 => {
                let (first, middle, last) = (-fx + 1.5, fx - 1.0, fx - 0.5);
                [
                    [first * first * 0.5, -(middle * middle) + 0.75, last * last * 0.5, zero],
                    [-first, middle * -2.0, last, zero],
                ]
            }
            _ => {
                // From the second node, and from the third.
                let (a, b) = (fx - 1.0, -fx + 2.0);
                [
                    [
                        b * b * b / 6.0,
                        (a * 0.5 - 1.0) * a * a + 2.0 / 3.0,
                        (b * 0.5 - 1.0) * b * b + 2.0 / 3.0,
                        a * a * a / 6.0,
                    ],
                    [b * b * -0.5, (a * 1.5 - 2.0) * a, (-b * 1.5 + 2.0) * b, a * a * 0.5],
                ]
            }
        }
    }

    /// How far the first node lies below a particle, in cells, before it is rounded down.
    #[inline(always)]
    pub fn reach(&self) -> f32 {
        0.5 * (self.width - 2) as f32
    }
}
