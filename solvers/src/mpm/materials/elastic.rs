//! The constants of isotropic elasticity.

/// Lamé's constants in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// The shear modulus.
    pub mu: f32,
    /// Lamé's first.
    pub lambda: f32,
}

impl Elastic {
    /// From Young's modulus in Pa and Poisson's ratio, below 0.5; in the plane, of plane strain.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self {
            mu: (young / (2.0 * (1.0 + poisson))) as f32,
            lambda: (young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))) as f32,
        }
    }

    /// Both constants times the same.
    pub fn scaled(self, factor: f32) -> Self {
        Self { mu: self.mu * factor, lambda: self.lambda * factor }
    }

    /// The modulus of a pressure wave, `lambda + 2 mu`, in Pa.
    pub fn wave_modulus(self) -> f64 {
        f64::from(self.lambda) + 2.0 * f64::from(self.mu)
    }
}
