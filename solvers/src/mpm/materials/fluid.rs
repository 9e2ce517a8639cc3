//! A weakly compressible fluid without viscosity, as in mpm88 (Hu et al. 2018, "A moving least squares material point
//! method").

use crate::linear::Matrix;

/// The volume ratio after a step whose gradient of displacement is `f_trial - I`: `j (1 + dt div v)`, the first order
/// of the determinant.
pub fn volume_ratio<M: Matrix>(j: f32, f_trial: M) -> f32 {
    // The identity is taken away first, exactly, or the little that remains would be rounded with it.
    j * (1.0 + (f_trial - M::IDENTITY).trace())
}

/// The Kirchhoff stress in Pa, `stiffness (j - 1) I`: pressure, times the volume ratio, is `stiffness (1 - j)`.
pub fn stress<M: Matrix>(stiffness: f32, j: f32) -> M {
    M::isotropic(stiffness * (j - 1.0))
}

/// `stiffness / 2 (j - 1)^2`, in Pa: to second order the energy that belongs to [`stress`], which is
/// `stiffness (j - 1 - ln j)`.
pub fn energy(stiffness: f32, j: f32) -> f32 {
    0.5 * stiffness * (j - 1.0) * (j - 1.0)
}
