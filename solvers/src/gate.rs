//! Checks of a scene against published numbers or closed forms.

use crate::{Scene, SceneError, Simulation};

/// Makes what watches a run of a scene, if it is of the gate's solver.
pub type Gate = fn(&Scene) -> Result<Box<dyn Watch>, SceneError>;

/// Watches a run of a scene from its start to its end, and then says what came of it.
pub trait Watch {
    /// How many steps the run takes, at most.
    fn steps(&self) -> u64;

    /// The simulated time in s at which the run ends, for steps whose size is not known before. The check fails if
    /// [`steps`](Self::steps) do not come so far.
    fn until(&self) -> Option<f64> {
        None
    }

    /// After how many steps [`look`](Self::look) is called again; it is called before the first step and after the last
    /// too.
    fn every(&self) -> u64;

    /// Looks at the simulation.
    fn look(&mut self, simulation: &dyn Simulation);

    /// What was found, once the run has ended.
    fn findings(&self) -> Vec<Finding>;
}

/// A number that a run gave, beside what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What was measured, with its unit.
    pub what: String,
    /// Its value.
    pub measured: f64,
    /// The published or exact value.
    pub expected: f64,
    /// The least that passes.
    pub least: f64,
    /// The most that passes.
    pub most: f64,
    /// Where the expected value comes from.
    pub source: &'static str,
}

impl Finding {
    /// Whether the measured value passes.
    pub fn passes(&self) -> bool {
        (self.least..=self.most).contains(&self.measured)
    }
}
