//! How materials bear being deformed.

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

    fn wave_modulus(self) -> f64 {
        f64::from(self.lambda) + 2.0 * f64::from(self.mu)
    }
}

/// Constants of snow (Stomakhin et al. 2013).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snow {
    /// Where nothing has yielded.
    pub elastic: Elastic,
    /// `xi`: how fast it hardens.
    pub hardening: f32,
    /// `theta_c`: singular values yield below one less this.
    pub compression: f32,
    /// `theta_s`: singular values yield above one and this.
    pub stretch: f32,
}

impl Snow {
    /// With the limits and the hardening of the paper, table 2.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self { elastic: Elastic::new(young, poisson), hardening: 10.0, compression: 2.5e-2, stretch: 7.5e-3 }
    }
}

/// Constants of sand (Klar et al. 2016).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sand {
    /// Of the grains' skeleton.
    pub elastic: Elastic,
    /// `h0` to `h3` of the angle of friction in degrees.
    pub friction: [f32; 4],
    /// Whether volume gained while nothing presses on it is given back before it resists again.
    pub volume_correction: bool,
}

impl Sand {
    /// With the friction of the paper's examples, and with correction of volume.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self { elastic: Elastic::new(young, poisson), friction: [35.0, 9.0, 0.2, 10.0], volume_correction: true }
    }
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
    /// Snow.
    Snow(Snow),
    /// Sand.
    Sand(Sand),
}

impl Model {
    /// The modulus of the fastest wave in Pa.
    pub fn wave_modulus(&self) -> f64 {
        match self {
            Self::Fluid { stiffness } => f64::from(*stiffness),
            Self::NeoHookean(elastic) | Self::Corotated(elastic) => elastic.wave_modulus(),
            Self::Snow(snow) => snow.elastic.wave_modulus(),
            Self::Sand(sand) => sand.elastic.wave_modulus(),
        }
    }
}
