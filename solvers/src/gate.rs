//! Checks of a scene against published numbers or closed forms.

use crate::{Scene, Simulation};

/// Makes what watches a run of a scene.
pub type Gate = fn(&Scene) -> Box<dyn Watch>;

/// Watches a run of a scene from its start to its end, and then says what came of it.
pub trait Watch {
    /// How many steps the run takes.
    fn steps(&self) -> u64;

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
