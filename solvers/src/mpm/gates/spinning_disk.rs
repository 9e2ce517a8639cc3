//! What PIC, FLIP and APIC keep of a free spinning disk's angular momentum.

use super::{scheme, step_at, within};
use crate::mpm::MpmSetup;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str =
    "Jiang, Schroeder & Teran 2017, set-up of section 6.1; numbers of an independent program in double precision";

/// L / L0 at these times.
const TIMES: [f64; 5] = [0.01, 0.1, 0.5, 1.0, 2.0];
const PIC: [f64; 5] = [0.607430, 0.003007, 0.0, 0.0, 0.0];
const FLIP: [f64; 5] = [0.997660, 0.997063, 0.995637, 0.994248, 0.991035];

/// Angular momentum about the middle, of the disk's mass alone (rho pi R^4 omega / 2).
const CONTINUUM: f64 = 1.017876e-2;

pub(super) struct SpinningDisk {
    scene: Scene,
    setup: MpmSetup,
    start: f64,
    start_energy: f64,
    /// Relative angular momentum at each of the times.
    kept: Vec<(f64, f64)>,
    end_energy: f64,
}

impl SpinningDisk {
    pub(super) fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        Self {
            scene: scene.clone(),
            setup: setup.clone(),
            start: 0.0,
            start_energy: 0.0,
            kept: Vec::new(),
            end_energy: 0.0,
        }
    }

    fn about_middle(&self, simulation: &dyn Simulation) -> f64 {
        let (totals, [x, y, _]) = (simulation.totals(), self.scene.extent().map(|side| 0.5 * side));
        totals.angular_momentum[2] - x * totals.momentum[1] + y * totals.momentum[0]
    }
}

impl Watch for SpinningDisk {
    fn steps(&self) -> u64 {
        step_at(&self.scene, 2.0)
    }

    fn every(&self) -> u64 {
        step_at(&self.scene, 0.01)
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let (momentum, energy) = (self.about_middle(simulation), simulation.energy());
        self.end_energy = energy.kinetic + energy.elastic;
        if simulation.steps() == 0 {
            (self.start, self.start_energy) = (momentum, energy.kinetic);
        } else if let Some(&time) = TIMES.iter().find(|&&time| step_at(&self.scene, time) == simulation.steps()) {
            self.kept.push((time, momentum / self.start));
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let mut findings =
            vec![within("L0 in kg m^2/s".into(), self.start, CONTINUUM, 0.015 * CONTINUUM, "rho pi R^4 omega / 2")];
        let (kept, tolerance, energy) = match scheme(&self.setup) {
            Some("PIC") => (PIC, 2e-4, None),
            Some("FLIP") => (FLIP, 2e-4, Some(0.992531)),
            // Any affine or richer field keeps all of it.
            _ => ([1.0; 5], 1e-3, Some(0.999998)),
        };
        for ((time, measured), expected) in self.kept.iter().zip(kept) {
            findings.push(within(format!("L / L0 at {time} s"), *measured, expected, tolerance, SOURCE));
        }
        if let Some(expected) = energy {
            let measured = self.end_energy / self.start_energy;
            findings.push(within("energy at 2 s over that at the start".into(), measured, expected, 2e-3, SOURCE));
        }
        findings
    }
}
