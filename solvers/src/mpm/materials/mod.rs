//! How materials bear being deformed.

/// Lamé's constants in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// The shear modulus.
    pub mu: f32,
    /// Lamé's first.
    pub lambda: f32,
}

/// A material's law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    /// Weakly compressible.
    Fluid {
        /// Bulk modulus in Pa.
        stiffness: f32,
    },
    /// Neo-Hookean.
    NeoHookean(Elastic),
    /// Fixed corotated.
    Corotated(Elastic),
}

impl Model {
    /// The modulus of the fastest wave in Pa.
    pub fn wave_modulus(&self) -> f64 {
        match self {
            Self::Fluid { stiffness } => f64::from(*stiffness),
            Self::NeoHookean(elastic) | Self::Corotated(elastic) => f64::from(elastic.lambda + 2.0 * elastic.mu),
        }
    }
}
