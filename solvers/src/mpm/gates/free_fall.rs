//! Before anything is touched, the middle of all mass falls as a stone does, and no mass is lost on the grid.

use super::within;
use crate::{Finding, Scene, Simulation, Watch};

pub(super) struct FreeFall {
    scene: Scene,
    start: Option<State>,
    end: Option<State>,
    grid_mass: f64,
}

#[derive(Clone, Copy)]
struct State {
    mass: f64,
    momentum: [f64; 3],
    /// Root mean square, in m/s.
    speed: f64,
}

impl FreeFall {
    pub(super) fn new(scene: &Scene) -> Self {
        Self { scene: scene.clone(), start: None, end: None, grid_mass: 0.0 }
    }
}

impl Watch for FreeFall {
    fn steps(&self) -> u64 {
        100
    }

    fn every(&self) -> u64 {
        100
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let totals = simulation.totals();
        let speed = (2.0 * simulation.energy().kinetic / totals.mass).sqrt();
        let state = State { mass: totals.mass, momentum: totals.momentum, speed };
        if simulation.steps() == 0 {
            self.start = Some(state);
        } else {
            self.end = Some(state);
            self.grid_mass = simulation.grid_mass().unwrap_or(f64::NAN);
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let (Some(start), Some(end)) = (self.start, self.end) else { return Vec::new() };
        let mut findings = vec![
            within("mass at the end over that at the start".into(), end.mass / start.mass, 1.0, 0.0, "conservation"),
            within(
                "mass on the grid over that of the particles".into(),
                self.grid_mass / end.mass,
                1.0,
                1e-6,
                "conservation",
            ),
        ];
        let time = self.steps() as f64 * self.scene.dt;
        for (axis, name) in ["first", "second", "third"].into_iter().enumerate().take(self.scene.dimensions) {
            let gained = (end.momentum[axis] - start.momentum[axis]) / end.mass;
            let expected = self.scene.gravity[axis] * time;
            let what = format!("velocity gained along the {name} axis in m/s");
            findings.push(within(what, gained, expected, 1e-4 * (end.speed + start.speed).max(0.1), "g t"));
        }
        findings
    }
}
