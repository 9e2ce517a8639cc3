//! The compressible neo-Hookean solid (Jiang et al. 2016, "The material point method for simulating continuum
//! materials", on hyperelasticity).
//!
//! What is left of `F` beside the identity is told apart before anything is squared, so that small strains are not lost
//! to rounding. A solid turned inside out has no such energy: it is not a number, nor is the stress.

use super::Elastic;
use crate::linear::Matrix;

impl Elastic {
    /// The Kirchhoff stress `mu (F F^T - I) + lambda ln(J) I`, in Pa.
    pub fn neo_hookean_stress<M: Matrix>(self, deformation_gradient: M) -> M {
        let change = deformation_gradient - M::IDENTITY;
        let strain = change + change.transpose() + change * change.transpose();
        strain * self.mu + M::isotropic(self.lambda * deformation_gradient.volume_change().ln_1p())
    }

    /// The energy `mu / 2 (tr(F^T F) - d) - mu ln J + lambda / 2 ln(J)^2`, in Pa.
    pub fn neo_hookean_energy<M: Matrix>(self, deformation_gradient: M) -> f32 {
        let change = deformation_gradient - M::IDENTITY;
        let logarithm = deformation_gradient.volume_change().ln_1p();
        // The trace of F^T F - I.
        let stretch = 2.0 * change.trace() + change.norm_squared();
        self.mu * (0.5 * stretch - logarithm) + 0.5 * self.lambda * logarithm * logarithm
    }
}
