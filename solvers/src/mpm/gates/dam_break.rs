//! The front of a column of water that is let go (Martin & Moyce 1952).

use super::{step_at, within};
use crate::mpm::MpmSetup;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str = "Martin & Moyce 1952, table 2 (n^2 = 2)";

/// The front's place `z / a` at times `t sqrt(2 g / a)`, with the column's width `a`.
const FRONT: [(f64, f64); 8] =
    [(1.19, 1.44), (1.43, 1.67), (1.63, 1.89), (1.98, 2.33), (2.32, 2.78), (2.65, 3.22), (2.98, 3.67), (3.33, 4.11)];

/// The experiment's gate takes a moment to leave: its clock begins so much earlier, in the same unit (the value by which
/// others shift their results too).
const RELEASE: f64 = 0.175;

/// How far from the experiment passes.
const TOLERANCE: f64 = 0.3;

pub(super) struct DamBreak {
    scene: Scene,
    /// The column's width in m, and where it begins.
    width: f64,
    from: f64,
    front: Vec<(f64, f64)>,
}

impl DamBreak {
    pub(super) fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        let (width, from) = match &setup.bodies[0].shape {
            crate::scene::Shape::Box { from, to, .. } => (to[0] - from[0], from[0]),
            _ => (1.0, 0.0),
        };
        Self { scene: scene.clone(), width, from, front: Vec::new() }
    }

    fn step_of(&self, scaled: f64) -> u64 {
        step_at(&self.scene, (scaled - RELEASE) / (2.0 * self.scene.gravity[1].abs() / self.width).sqrt())
    }
}

impl Watch for DamBreak {
    fn steps(&self) -> u64 {
        self.step_of(FRONT[FRONT.len() - 1].0)
    }

    fn every(&self) -> u64 {
        1
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        if let Some(&(time, _)) = FRONT.iter().find(|(time, _)| self.step_of(*time) == simulation.steps()) {
            // The foremost particle may have been flung: the front is where all but a thousandth lie behind.
            let mut along: Vec<f64> = simulation.positions().iter().map(|x| x[0]).collect();
            let rank = along.len() - 1 - along.len() / 1000;
            let (_, foremost, _) = along.select_nth_unstable_by(rank, f64::total_cmp);
            self.front.push((time, (*foremost + 0.5 * simulation.spacing() - self.from) / self.width));
        }
    }

    fn findings(&self) -> Vec<Finding> {
        self.front
            .iter()
            .zip(FRONT)
            .map(|((time, measured), (_, expected))| {
                within(
                    format!("front z / a at t sqrt(2 g / a) = {time}, gate's delay of {RELEASE} counted"),
                    *measured,
                    expected,
                    TOLERANCE,
                    SOURCE,
                )
            })
            .collect()
    }
}
