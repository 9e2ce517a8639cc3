//! The front of a column of water that is let go (Martin & Moyce 1952).

use super::{MOST_STEPS, corners, within};
use crate::scene::Body;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str = "Martin & Moyce 1952, table 2 (n^2 = 2)";

/// The front's place `z / a` at times `t sqrt(2 g / a)`, with the column's width `a`.
const FRONT: [(f64, f64); 13] = [
    (0.41, 1.11),
    (0.84, 1.22),
    (1.19, 1.44),
    (1.43, 1.67),
    (1.63, 1.89),
    (1.83, 2.11),
    (1.98, 2.33),
    (2.20, 2.56),
    (2.32, 2.78),
    (2.51, 3.00),
    (2.65, 3.22),
    (2.83, 3.44),
    (2.98, 3.67),
];

/// The experiment's clock began when its gate began to leave, at most so much before the water was free, in the same unit (the value by which others
/// shift their results, too); one delay for all times.
const MOST_DELAY: f64 = 0.175;

/// How far from the experiment passes.
const SHARE: f64 = 0.05;

pub(super) struct DamBreak {
    /// Of the column, in m.
    width: f64,
    from: f64,
    /// Seconds that are one in the table's unit.
    unit: f64,
    /// Times in that unit, and the front.
    front: Vec<(f64, f64)>,
}

impl DamBreak {
    pub(super) fn new(scene: &Scene, body: &Body) -> Self {
        let (from, to) = corners(body);
        let width = to[0] - from[0];
        Self { width, from: from[0], unit: (width / (2.0 * scene.gravity[1].abs())).sqrt(), front: Vec::new() }
    }

    /// The front at a time, between those at which it was seen.
    fn at(&self, time: f64) -> f64 {
        let next = self.front.partition_point(|(seen, _)| *seen < time).clamp(1, self.front.len() - 1);
        let ((before, low), (after, high)) = (self.front[next - 1], self.front[next]);
        low + (high - low) * (time - before) / (after - before)
    }

    fn worst(&self, delay: f64) -> f64 {
        FRONT.iter().map(|(time, front)| (self.at(time - delay) / front - 1.0).abs()).fold(0.0, f64::max)
    }
}

impl Watch for DamBreak {
    fn steps(&self) -> u64 {
        MOST_STEPS
    }

    fn until(&self) -> Option<f64> {
        Some(FRONT[FRONT.len() - 1].0 * self.unit)
    }

    fn every(&self) -> u64 {
        4
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        // The front runs along the floor; what is flung up is none.
        let low = 2.5 * simulation.spacing();
        let along = simulation.positions().into_iter().filter(|x| x[1] < low).map(|x| x[0]).fold(0.0, f64::max);
        let front = (along + 0.5 * simulation.spacing() - self.from) / self.width;
        self.front.push((simulation.time() / self.unit, front));
    }

    fn findings(&self) -> Vec<Finding> {
        if self.front.len() < 2 {
            return Vec::new();
        }
        // The delay that agrees best, to a thousandth.
        let delays = (0..=(MOST_DELAY * 1000.0) as u32).map(|n| f64::from(n) * 1e-3);
        let delay = delays.min_by(|&a, &b| self.worst(a).total_cmp(&self.worst(b))).unwrap_or(0.0);
        let finding = |&(time, expected): &(f64, f64)| {
            let what = format!("front z / a at t sqrt(2 g / a) = {time}, a delay of {delay:.3} counted");
            within(what, self.at(time - delay), expected, SHARE, SOURCE)
        };
        FRONT.iter().map(finding).collect()
    }
}
