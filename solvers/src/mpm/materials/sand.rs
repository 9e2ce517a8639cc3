//! Dry sand (Klár et al. 2016, "Drucker-Prager elastoplasticity for sand animation"): Hencky's strains within a cone of
//! friction that hardens, without cohesion.

use super::{Elastic, FLATTEST, Updated, along};
use crate::linear::{Matrix, Svd};

/// Constants of sand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sand {
    /// Of the grains' skeleton.
    pub elastic: Elastic,
    /// `h0` to `h3` of the angle of friction in degrees, `h0 + (h1 q - h3) exp(-h2 q)` where `q` is the hardening; `h1`
    /// and `h2` are per unit of it.
    pub friction: [f32; 4],
    /// Whether what sand gains in volume while nothing presses on it is given back before it resists again (Tampubolon
    /// et al. 2017, "Multi-species simulation of porous sand and water mixtures", section 4.3.4).
    pub volume_correction: bool,
}

/// What a trial comes to.
struct Mapped<S> {
    /// Elastic logarithmic strains.
    strains: S,
    plastic: [f32; 2],
    /// Whether strains are no longer those of the trial.
    changed: bool,
}

impl Sand {
    /// With the friction of the paper's examples, from 25 degrees at first, and with correction of volume. There
    /// Young's modulus is 3.537e5 Pa and Poisson's ratio 0.3.
    pub fn new(young: f64, poisson: f64) -> Self {
        Self { elastic: Elastic::new(young, poisson), friction: [35.0, 9.0, 0.2, 10.0], volume_correction: true }
    }

    /// The angle of friction in degrees of sand of that hardening.
    pub fn friction_angle(&self, hardening: f32) -> f32 {
        let [h0, h1, h2, h3] = self.friction;
        h0 + (h1 * hardening - h3) * (-h2 * hardening).exp()
    }

    /// Elastic singular values and what a particle remembers (its hardening and its correction of volume), from those
    /// before.
    ///
    /// Where sand expands nothing holds it: it comes to the cone's tip, without stress. Where it is sheared more than
    /// its pressure bears, shear strain is taken off without changing the volume. Otherwise it is elastic; so it is
    /// under even pressure, which the letter of the paper's algorithm takes to the tip, against its yield criterion.
    ///
    /// Singular values are taken as at least 0.05, negative ones too, and at most 20.
    pub fn return_map<S: Copy + AsRef<[f32]> + AsMut<[f32]>>(&self, trial: S, plastic: [f32; 2]) -> (S, [f32; 2]) {
        let Mapped { strains: mut sigma, plastic, changed } = self.map(trial, plastic);
        for value in sigma.as_mut() {
            *value = value.exp();
        }
        (if changed { sigma } else { trial }, plastic)
    }

    fn map<S: Copy + AsRef<[f32]> + AsMut<[f32]>>(&self, trial: S, [hardening, correction]: [f32; 2]) -> Mapped<S> {
        let dimensions = trial.as_ref().len() as f32;
        let (mut strains, mut changed) = (trial, false);
        for value in strains.as_mut() {
            let clamped = value.clamp(FLATTEST, 1.0 / FLATTEST);
            changed |= clamped != *value;
            *value = clamped.ln();
        }
        let increment = norm(strains.as_ref());
        if self.volume_correction && correction != 0.0 {
            changed = true;
            strains.as_mut().iter_mut().for_each(|strain| *strain += correction / dimensions);
        }
        let trace: f32 = strains.as_ref().iter().sum();
        // What the correction is once it has been applied: all that the tip does not hold.
        let remembered = |gain: f32| if self.volume_correction { gain } else { correction };

        if trace > 0.0 {
            strains.as_mut().fill(0.0);
            // Hardening counts what is strained in this step, not what had been gained before.
            return Mapped { strains, plastic: [hardening + increment, remembered(trace)], changed: true };
        }
        let mut deviator = strains;
        deviator.as_mut().iter_mut().for_each(|strain| *strain -= trace / dimensions);
        let shear = norm(deviator.as_ref());
        let Elastic { mu, lambda } = self.elastic;
        let slope = cone_slope(self.friction_angle(hardening));
        let flow = shear + (dimensions * lambda + 2.0 * mu) / (2.0 * mu) * trace * slope;
        if flow <= 0.0 {
            return Mapped { strains, plastic: [hardening, remembered(0.0)], changed };
        }
        for (strain, deviator) in strains.as_mut().iter_mut().zip(deviator.as_ref()) {
            *strain -= flow / shear * deviator;
        }
        Mapped { strains, plastic: [hardening + flow, remembered(0.0)], changed: true }
    }

    pub(super) fn update<M: Matrix>(&self, f_trial: M, plastic: [f32; 2]) -> Updated<M> {
        let svd = f_trial.svd();
        let Mapped { strains, plastic, changed } = self.map(svd.sigma, plastic);
        let mut sigma = strains;
        sigma.as_mut().iter_mut().for_each(|value| *value = value.exp());
        let Elastic { mu, lambda } = self.elastic;
        let trace: f32 = strains.as_ref().iter().sum();
        let mut stress = strains;
        stress.as_mut().iter_mut().for_each(|strain| *strain = 2.0 * mu * *strain + lambda * trace);
        Updated {
            deformation_gradient: if changed { Svd { sigma, ..svd }.product() } else { f_trial },
            plastic,
            kirchhoff_stress: along(svd.u, stress),
        }
    }

    /// Hencky's energy `mu tr(ln(Sigma)^2) + lambda / 2 tr(ln Sigma)^2`, in Pa.
    pub(super) fn energy<S: Copy + AsRef<[f32]> + AsMut<[f32]>>(&self, sigma: S) -> f32 {
        let mut strains = sigma;
        strains.as_mut().iter_mut().for_each(|value| *value = value.clamp(FLATTEST, 1.0 / FLATTEST).ln());
        let (strains, Elastic { mu, lambda }) = (strains.as_ref(), self.elastic);
        let (trace, norm) = (strains.iter().sum::<f32>(), norm(strains));
        mu * norm * norm + 0.5 * lambda * trace * trace
    }
}

/// How steep the cone of an angle of friction in degrees is: `sqrt(2/3) 2 sin / (3 - sin)`, which meets Mohr and
/// Coulomb's criterion under triaxial compression. In the plane it is taken to be the same, though there it is Mohr and
/// Coulomb's for a smaller angle, of the sine `sqrt(2)` times this: 27.5 degrees instead of 30.
pub fn cone_slope(angle: f32) -> f32 {
    let sine = angle.to_radians().sin();
    (2f32 / 3.0).sqrt() * 2.0 * sine / (3.0 - sine)
}

fn norm(values: &[f32]) -> f32 {
    values.iter().map(|value| value * value).sum::<f32>().sqrt()
}
