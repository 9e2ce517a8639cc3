//! How far a column of sand runs out (Lube et al. 2005).

use super::{step_at, within};
use crate::mpm::MpmSetup;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str = "Lube, Huppert, Sparks & Freundt 2005, planar columns below h / d = 1.8";

pub(super) struct SandColumn {
    scene: Scene,
    /// Width and height of the column in m, and where it begins.
    width: f64,
    height: f64,
    from: f64,
    front: f64,
    speed: f64,
}

impl SandColumn {
    pub(super) fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        let (width, height, from) = match &setup.bodies[0].shape {
            crate::scene::Shape::Box { from, to, .. } => (to[0] - from[0], to[1] - from[1], from[0]),
            _ => (1.0, 1.0, 0.0),
        };
        Self { scene: scene.clone(), width, height, from, front: 0.0, speed: 0.0 }
    }

    /// Twice as long as the heap takes to come to rest: 3.3 sqrt(h / g).
    fn end(&self) -> f64 {
        6.6 * (self.height / self.scene.gravity[1].abs()).sqrt()
    }
}

impl Watch for SandColumn {
    fn steps(&self) -> u64 {
        step_at(&self.scene, self.end())
    }

    fn every(&self) -> u64 {
        self.steps()
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        // The heap's edge, not its stray grains: where all but two in a thousand lie behind.
        let mut along: Vec<f64> = simulation.positions().iter().map(|x| x[0]).collect();
        let rank = along.len() - 1 - along.len() / 500;
        let (_, foremost, _) = along.select_nth_unstable_by(rank, f64::total_cmp);
        self.front = *foremost + 0.5 * simulation.spacing();
        let speeds = simulation.velocities().iter().map(|v| v.iter().map(|v| v * v).sum::<f64>()).sum::<f64>();
        self.speed = (speeds / along.len() as f64).sqrt();
    }

    fn findings(&self) -> Vec<Finding> {
        let aspect = self.height / self.width;
        let (measured, expected) = ((self.front - self.from) / self.width - 1.0, 1.2 * aspect);
        let fall = (2.0 * self.scene.gravity[1].abs() * self.height).sqrt();
        vec![
            within(
                format!("run-out (d - d0) / d0 of a column of h / d0 = {aspect:.2}"),
                measured,
                expected,
                0.15 * expected,
                SOURCE,
            ),
            Finding {
                what: "root mean square of the speed at the end over that of a free fall".into(),
                measured: self.speed / fall,
                expected: 0.0,
                least: 0.0,
                most: 0.02,
                source: "a heap comes to rest",
            },
        ]
    }
}
