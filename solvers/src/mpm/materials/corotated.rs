//! The fixed corotated solid (Stomakhin et al. 2012, "Energetically consistent invertible elasticity"): it has a stress
//! where it is turned inside out, too, which pushes it back.

use super::{Elastic, along};
use crate::linear::{Matrix, Svd};

impl Elastic {
    /// The Kirchhoff stress `2 mu (F - R) F^T + lambda (J - 1) J I`, in Pa, with the rotation `R` of the polar
    /// decomposition.
    pub fn corotated_stress<M: Matrix>(self, deformation_gradient: M) -> M {
        let rotation = deformation_gradient.polar().rotation;
        let change = deformation_gradient.volume_change();
        let deviation = (deformation_gradient - rotation) * deformation_gradient.transpose();
        deviation * (2.0 * self.mu) + M::isotropic(self.lambda * change * (1.0 + change))
    }

    /// The same stress from singular values, of which the rotation on the right is of no account.
    pub fn corotated_principal_stress<M: Matrix>(self, svd: &Svd<M>) -> M {
        let j: f32 = svd.sigma.as_ref().iter().product();
        let mut stress = svd.sigma;
        for value in stress.as_mut() {
            *value = 2.0 * self.mu * (*value - 1.0) * *value + self.lambda * (j - 1.0) * j;
        }
        along(svd.u, stress)
    }

    /// The energy `mu |F - R|^2 + lambda / 2 (J - 1)^2`, in Pa.
    pub fn corotated_energy<M: Matrix>(self, deformation_gradient: M) -> f32 {
        let rotation = deformation_gradient.polar().rotation;
        let change = deformation_gradient.volume_change();
        self.mu * (deformation_gradient - rotation).norm_squared() + 0.5 * self.lambda * change * change
    }
}
