//! The semi-axes of a drop that is stretched (Monaghan 1994).

use super::{MOST_STEPS, within};
use crate::scene::{Body, Shape};
use crate::{Finding, Simulation, Watch};

const SOURCE: &str = "Monaghan 1994, elliptical drop: A' = A^2 (a^4 - 1) / (a^4 + 1), a' = -a A";

/// Time in s, and the semi-axes of a drop of radius 1 m that is stretched at 100 1/s.
const AXES: [(f64, f64, f64); 3] =
    [(0.0008, 0.923273, 1.083103), (0.0038, 0.694821, 1.439219), (0.0076, 0.514266, 1.944517)];

/// How far from the exact solution passes.
const SHARE: f64 = 0.02;

pub(super) struct EllipticalDrop {
    center: [f64; 3],
    /// Simulated time, and the semi-axes.
    found: Vec<(f64, f64, f64)>,
}

impl EllipticalDrop {
    pub(super) fn new(body: &Body) -> Self {
        let center = if let Shape::Ball { center, .. } = body.shape { center } else { [0.0; 3] };
        Self { center, found: Vec::new() }
    }
}

impl Watch for EllipticalDrop {
    fn steps(&self) -> u64 {
        MOST_STEPS
    }

    fn until(&self) -> Option<f64> {
        Some(AXES[AXES.len() - 1].0)
    }

    fn every(&self) -> u64 {
        1
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        if AXES.get(self.found.len()).is_none_or(|(time, ..)| simulation.time() < *time) {
            return;
        }
        // Of a drop that is filled evenly, the mean square of a coordinate is a quarter of the semi-axis' square.
        let x = simulation.positions();
        let axis = |axis: usize| {
            let squares: f64 = x.iter().map(|x| (x[axis] - self.center[axis]).powi(2)).sum();
            2.0 * (squares / x.len() as f64).sqrt()
        };
        self.found.push((simulation.time(), axis(0), axis(1)));
    }

    fn findings(&self) -> Vec<Finding> {
        let both = self.found.iter().zip(AXES).map(|((_, a, b), (time, exact_a, exact_b))| {
            [
                within(format!("semi-axis a at {time} s, in m"), *a, exact_a, SHARE, SOURCE),
                within(format!("semi-axis b at {time} s, in m"), *b, exact_b, SHARE, SOURCE),
            ]
        });
        both.flatten().collect()
    }
}
