//! Until the floor is reached, the middle of all mass falls with drag alone, whatever the springs do.

use super::{SpringsSetup, within};
use crate::{Finding, Simulation, Watch};

pub(super) struct ThreePoints {
    setup: SpringsSetup,
    /// Momentum and its moment about the middle at the end, and mass.
    end: Option<([f64; 3], f64)>,
    /// The largest distance of two masses that are joined, over the length at rest, at the end.
    stretch: f64,
}

/// Before the lowest mass reaches the floor.
const STEPS: u64 = 200;

impl ThreePoints {
    pub(super) fn new(setup: &SpringsSetup) -> Self {
        Self { setup: setup.clone(), end: None, stretch: 0.0 }
    }
}

impl Watch for ThreePoints {
    fn steps(&self) -> u64 {
        STEPS
    }

    fn every(&self) -> u64 {
        STEPS
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let totals = simulation.totals();
        self.end = Some((totals.momentum, totals.mass));
        let x = simulation.positions();
        let distance = |[a, b]: [u32; 2]| {
            let (a, b) = (x[a as usize], x[b as usize]);
            a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
        };
        let relative = self.setup.springs.iter().map(|spring| (distance(spring.ends) / spring.bond.rest - 1.0).abs());
        self.stretch = relative.fold(0.0, f64::max);
    }

    fn findings(&self) -> Vec<Finding> {
        let Some((momentum, mass)) = self.end else { return Vec::new() };
        let parameters = &self.setup.parameters;
        let q = (-parameters.dt * parameters.drag).exp();
        let sum = if q == 1.0 { STEPS as f64 } else { q * (1.0 - q.powi(STEPS as i32)) / (1.0 - q) };
        let fallen = parameters.gravity.y * parameters.dt * sum;
        let source = "g dt q (1 - q^n) / (1 - q), q = exp(-dt drag): springs pull both ends alike";
        vec![
            within(
                "velocity of the middle along the second axis in m/s".into(),
                momentum[1] / mass,
                fallen,
                1e-12,
                source,
            ),
            within("velocity of the middle along the first axis in m/s".into(), momentum[0] / mass, 0.0, 1e-12, source),
            within(
                "largest relative stretch of a spring".into(),
                self.stretch,
                0.0,
                1e-3,
                "three springs of one length make an equilateral triangle, which dashpots bring to rest",
            ),
        ]
    }
}
