//! How materials bear being deformed.
//!
//! A particle remembers its deformation gradient, of which plastic materials keep the elastic part only, and two
//! numbers more. A step hands its trial, `(I + dt grad v) F`, to [`Model::update`], which lets the material yield and
//! tells the Kirchhoff stress `tau = J sigma = P F^T`, in Pa of the volume at rest: the material point method weighs it
//! by that volume.
//!
//! In the plane materials are in plane strain.

mod corotated;
mod elastic;
pub mod fluid;
mod neo_hookean;
mod sand;
mod snow;

use crate::linear::Matrix;

pub use elastic::Elastic;
pub use sand::{Sand, cone_slope};
pub use snow::Snow;

/// What no law of plasticity takes singular values to be below. A step in which no particle crosses a cell does not
/// flatten one that far; where it happens all the same, turned inside out even, the logarithm remains finite.
const FLATTEST: f32 = 0.05;

/// A material's law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    /// Weakly compressible: [`fluid`].
    Fluid {
        /// Bulk modulus in Pa.
        stiffness: f32,
    },
    /// [`Elastic::neo_hookean_stress`].
    NeoHookean(Elastic),
    /// [`Elastic::corotated_stress`].
    Corotated(Elastic),
    /// [`Snow::return_map`].
    Snow(Snow),
    /// [`Sand::return_map`].
    Sand(Sand),
}

/// A particle after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Updated<M> {
    /// Its elastic part.
    pub deformation_gradient: M,
    /// See [`Model::initial_plastic`].
    pub plastic: [f32; 2],
    /// In Pa.
    pub kirchhoff_stress: M,
}

impl Model {
    /// What a particle at rest remembers beside its deformation gradient: for a fluid its volume over that at rest, for
    /// snow its plastic part of that, for sand the hardening `q` and the logarithm of the volume that it gained without
    /// resistance.
    pub fn initial_plastic(&self) -> [f32; 2] {
        match self {
            Self::Fluid { .. } | Self::Snow(_) => [1.0, 0.0],
            Self::NeoHookean(_) | Self::Corotated(_) | Self::Sand(_) => [0.0, 0.0],
        }
    }

    /// Lets the material yield, and tells its stress. What does not yield keeps its deformation gradient to the last
    /// bit.
    // Called from many kernels: compiled once for each dimension.
    #[inline(never)]
    pub fn update<M: Matrix>(&self, f_trial: M, plastic: [f32; 2]) -> Updated<M> {
        let elastic = |kirchhoff_stress| Updated { deformation_gradient: f_trial, plastic, kirchhoff_stress };
        match self {
            Self::Fluid { stiffness } => {
                let j = fluid::volume_ratio(plastic[0], f_trial);
                Updated {
                    deformation_gradient: M::IDENTITY,
                    plastic: [j, 0.0],
                    kirchhoff_stress: fluid::stress(*stiffness, j),
                }
            }
            Self::NeoHookean(constants) => elastic(constants.neo_hookean_stress(f_trial)),
            Self::Corotated(constants) => elastic(constants.corotated_stress(f_trial)),
            Self::Snow(snow) => snow.update(f_trial, plastic),
            Self::Sand(sand) => sand.update(f_trial, plastic),
        }
    }

    /// The elastic energy over the volume at rest, in J/m^3 (J/m^2 in the plane).
    pub fn energy<M: Matrix>(&self, deformation_gradient: M, plastic: [f32; 2]) -> f32 {
        match self {
            Self::Fluid { stiffness } => fluid::energy(*stiffness, plastic[0]),
            Self::NeoHookean(constants) => constants.neo_hookean_energy(deformation_gradient),
            Self::Corotated(constants) => constants.corotated_energy(deformation_gradient),
            Self::Snow(snow) => snow.hardened(plastic[0]).corotated_energy(deformation_gradient),
            Self::Sand(sand) => sand.energy(deformation_gradient.svd().sigma),
        }
    }

    /// The modulus of the fastest wave in Pa, `lambda + 2 mu` in solids at rest. Snow is taken as hardened by a tenth
    /// of compaction (`e` times as stiff with the paper's constants): its drifts and balls seldom have more.
    pub fn wave_modulus(&self) -> f64 {
        match self {
            Self::Fluid { stiffness } => f64::from(*stiffness),
            Self::NeoHookean(elastic) | Self::Corotated(elastic) => elastic.wave_modulus(),
            Self::Snow(snow) => snow.hardened(0.9).wave_modulus(),
            Self::Sand(sand) => sand.elastic.wave_modulus(),
        }
    }

    /// By which scenes ask for it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Fluid { .. } => "fluid",
            Self::NeoHookean(_) => "neo-hookean",
            Self::Corotated(_) => "corotated",
            Self::Snow(_) => "snow",
            Self::Sand(_) => "sand",
        }
    }
}

/// `U diag(values) U^T`.
fn along<M: Matrix>(u: M, values: M::Singular) -> M {
    u * M::from_diagonal(values) * u.transpose()
}
