//! Snow (Stomakhin et al. 2013, "A material point method for snow simulation"): fixed corotated, yielding beyond limits
//! of compression and stretch, and harder the more it has been compacted.

use super::{Elastic, FLATTEST, Updated};
use crate::linear::{Matrix, Svd};

/// Between which the plastic volume ratio is kept, as in `mls-mpm88.cpp` of Hu et al. 2018: otherwise the factor
/// `exp(hardening (1 - J_P))` of a crushed particle outgrows any time step (with the paper's hardening it stays below
/// 55), and the ratio of one that is stretched for ever overflows.
const PLASTIC_VOLUME: (f32, f32) = (0.6, 20.0);

/// Constants of snow.
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
    /// With the limits and the hardening of the paper, table 2, where Young's modulus is 1.4e5 Pa and Poisson's ratio
    /// 0.2.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self { elastic: Elastic::new(young, poisson), hardening: 10.0, compression: 2.5e-2, stretch: 7.5e-3 }
    }

    /// How much stiffer snow of that plastic volume ratio is: `exp(hardening (1 - J_P))`.
    pub fn hardening_factor(&self, plastic_volume: f32) -> f32 {
        (self.hardening * (1.0 - plastic_volume)).exp()
    }

    /// The constants of snow of that plastic volume ratio (eq. 2).
    pub fn hardened(&self, plastic_volume: f32) -> Elastic {
        self.elastic.scaled(self.hardening_factor(plastic_volume))
    }

    /// Clamps singular values to what is borne, and gives the plastic volume what they lose (section 7), which is kept
    /// between 0.6 and 20. A value below 0.05, or a negative one, counts as 0.05 there.
    pub fn return_map<S: Copy + AsRef<[f32]> + AsMut<[f32]>>(&self, trial: S, plastic_volume: f32) -> (S, f32) {
        let (mut sigma, mut plastic_volume) = (trial, plastic_volume);
        for value in sigma.as_mut() {
            let clamped = value.clamp(1.0 - self.compression, 1.0 + self.stretch);
            if clamped != *value {
                plastic_volume *= value.max(FLATTEST) / clamped;
                *value = clamped;
            }
        }
        let (least, most) = PLASTIC_VOLUME;
        (sigma, plastic_volume.clamp(least, most))
    }

    pub(super) fn update<M: Matrix>(&self, f_trial: M, [plastic_volume, _]: [f32; 2]) -> Updated<M> {
        let svd = f_trial.svd();
        let (sigma, plastic_volume) = self.return_map(svd.sigma, plastic_volume);
        let yielded = Svd { sigma, ..svd };
        Updated {
            deformation_gradient: if sigma == svd.sigma { f_trial } else { yielded.product() },
            plastic: [plastic_volume, 0.0],
            kirchhoff_stress: self.hardened(plastic_volume).corotated_principal_stress(&yielded),
        }
    }
}
