//! A mode of a chain held at both ends, in the discrete time of the integrator.

use std::f64::consts::PI;

use super::{SpringsSetup, within};
use crate::mass_spring::Integrator;
use crate::{Finding, Simulation, Watch};

pub(super) struct Chain {
    setup: SpringsSetup,
    start: Vec<f64>,
    /// The largest distance of the middle mass from the closed form.
    error: f64,
    momentum: f64,
}

/// A few periods.
const STEPS: u64 = 2000;

impl Chain {
    pub(super) fn new(setup: &SpringsSetup) -> Self {
        Self { setup: setup.clone(), start: Vec::new(), error: 0.0, momentum: 0.0 }
    }

    /// How far a mass is from where it is at rest, which is as far from the next as all others are.
    fn displacement(x: &[[f64; 3]], n: usize) -> f64 {
        let last = x.len() - 1;
        x[n][0] - x[0][0] - (x[last][0] - x[0][0]) * n as f64 / last as f64
    }

    /// The frequency of the first mode, `2 sqrt(k / m) sin(pi / 2 / springs)`.
    fn frequency(&self) -> f64 {
        let (spring, mass) = (&self.setup.springs[0], &self.setup.masses[1]);
        2.0 * (spring.bond.stiffness / mass.mass).sqrt() * (0.5 * PI / self.setup.springs.len() as f64).sin()
    }

    /// What symplectic Euler makes of the amplitude 1 at rest after so many steps: with
    /// `cos(phase) = 1 - (w dt)^2 / 2`, it is `cos(n phase) - tan(phase / 2) sin(n phase)`.
    fn oscillation(&self, steps: u64) -> f64 {
        let phase = 2.0 * (0.5 * self.frequency() * self.setup.parameters.dt).asin();
        let turned = steps as f64 * phase;
        turned.cos() - (0.5 * phase).tan() * turned.sin()
    }
}

impl Watch for Chain {
    fn steps(&self) -> u64 {
        STEPS
    }

    fn every(&self) -> u64 {
        10
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let x = simulation.positions();
        let count = x.len();
        let displaced: Vec<f64> = (0..count).map(|n| Self::displacement(&x, n)).collect();
        if simulation.steps() == 0 {
            self.start.clone_from(&displaced);
        }
        let factor = self.oscillation(simulation.steps());
        let errors = displaced.iter().zip(&self.start).map(|(now, start)| (now - factor * start).abs());
        self.error = errors.fold(self.error, f64::max);
        self.momentum = self.momentum.max(simulation.totals().momentum[1].abs());
    }

    fn findings(&self) -> Vec<Finding> {
        let amplitude = self.start.iter().copied().fold(0.0, f64::max);
        let mut findings = vec![within(
            "largest momentum across the chain in kg m/s".into(),
            self.momentum,
            0.0,
            1e-12,
            "symmetry; tension keeps it straight",
        )];
        if self.setup.parameters.integrator == Integrator::SymplecticEuler {
            findings.push(within(
                "largest distance of a mass from its mode, over the amplitude".into(),
                self.error / amplitude,
                0.0,
                1e-9,
                "w = 2 sqrt(k / m) sin(pi / 2n), phase a step 2 asin(w dt / 2)",
            ));
        }
        findings
    }
}
