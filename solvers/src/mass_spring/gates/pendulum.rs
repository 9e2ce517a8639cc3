//! The period of a pendulum of any amplitude, which elliptic integrals give.

use std::f64::consts::PI;

use super::{SpringsSetup, within};
use crate::{Finding, Simulation, Watch};

pub(super) struct Pendulum {
    setup: SpringsSetup,
    last: Option<(f64, f64)>,
    /// When it went through the middle.
    crossings: Vec<f64>,
    start: f64,
    /// Largest relative change of the energy.
    drift: f64,
}

impl Pendulum {
    pub(super) fn new(setup: &SpringsSetup) -> Self {
        Self { setup: setup.clone(), last: None, crossings: Vec::new(), start: 0.0, drift: 0.0 }
    }

    /// The length at rest, and the angle from which it starts.
    fn shape(&self) -> (f64, f64) {
        let d = self.setup.masses[1].x - self.setup.masses[0].x;
        (d.length(), d.x.abs().atan2(-d.y))
    }

    /// `4 sqrt(l / g) K(sin(angle / 2))`, with `K` by the arithmetic-geometric mean.
    fn period(&self) -> f64 {
        let (length, angle) = self.shape();
        let (mut a, mut b) = (1.0, (0.5 * angle).cos());
        for _ in 0..10 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        2.0 * PI * (length / self.setup.parameters.gravity.length()).sqrt() / a
    }
}

impl Watch for Pendulum {
    fn steps(&self) -> u64 {
        (2.3 * self.period() / self.setup.parameters.dt) as u64
    }

    fn every(&self) -> u64 {
        1
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let [pivot, bob] = [0, 1].map(|n| simulation.positions()[n]);
        let side = bob[0] - pivot[0];
        if let Some((time, before)) = self.last
            && before * side < 0.0
        {
            self.crossings.push(time + (simulation.time() - time) * before / (before - side));
        }
        self.last = Some((simulation.time(), side));
        let energy = simulation.energy();
        let gravity = self.setup.parameters.gravity.length();
        let mass = self.setup.masses[1].mass;
        let total = energy.kinetic + energy.elastic + mass * gravity * (bob[1] - pivot[1] + self.shape().0);
        if simulation.steps() == 0 {
            self.start = total;
        }
        self.drift = self.drift.max((total / self.start - 1.0).abs());
    }

    fn findings(&self) -> Vec<Finding> {
        let [first, .., last] = self.crossings[..] else { return Vec::new() };
        let measured = 2.0 * (last - first) / (self.crossings.len() - 1) as f64;
        let period = self.period();
        vec![
            within(
                "period in s".into(),
                measured,
                period,
                2e-4 * period,
                "4 sqrt(l / g) K(sin(angle / 2)), for a rod; the spring is longer by its stretch",
            ),
            within("largest relative change of the energy".into(), self.drift, 0.0, 2e-2, "conservation, within w dt"),
        ]
    }
}
