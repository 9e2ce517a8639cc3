//! `allotrope count`: what a step touches in each layout, loop by loop and member by member. The numbers are the same on every machine.

mod heat;
mod report;
mod text;

use std::path::Path;

use allotrope::probe::{self, Caches, RecordError, Recording};
use allotrope_solvers::{Scene, SolverInfo};
use indicatif::ProgressBar;

use super::errors::LabError;
use super::output;
pub use heat::HeatMap;
pub use report::{Layout, Loop, Member, Report};

/// What is to be counted.
#[derive(Debug)]
pub struct Plan {
    /// The solver.
    pub solver: &'static SolverInfo,
    /// The scene's name in the results.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// Layouts of the solver.
    pub layouts: Vec<&'static str>,
    /// Steps that are counted, from the start of the scene.
    pub steps: u64,
    /// The caches that are modelled.
    pub caches: Caches,
}

/// Counts what the plan says, prints it, and writes the report and pictures of the fields' memory where they are wanted.
///
/// # Errors
/// If accesses cannot be recorded in this build, the scene cannot be built, a step is refused, or a file cannot be written.
pub fn count(plan: &Plan, json: Option<&Path>, out: Option<&Path>) -> Result<(), LabError> {
    available()?;
    if let Some(path) = json {
        output::writable(path)?;
    }
    if let Some(folder) = out {
        output::folder(folder)?;
    }
    let bar = ProgressBar::new(plan.layouts.len() as u64);
    let mut report = Report::new(plan);
    for &layout in &plan.layouts {
        bar.set_message(layout);
        let (bytes, recording) = record(plan, layout)?;
        let counted = Layout::new(layout, bytes, &recording);
        if let Some(folder) = out {
            heat::write(folder, &counted)?;
        }
        report.layouts.push(counted);
        bar.inc(1);
    }
    bar.finish_and_clear();
    output::results(&text::text(&report), &report, json)
}

/// Checks that accesses can be recorded.
///
/// # Errors
/// One line that tells how to build the program so that they can.
pub fn available() -> Result<(), LabError> {
    match probe::AVAILABLE {
        true => Ok(()),
        false => Err(LabError::usage(format!(
            "{}; `cargo run --release --features probe -- count ..` builds one that can",
            RecordError::Unavailable
        ))),
    }
}

/// The counts of some steps in one layout, and the bytes of its fields after them.
///
/// # Errors
/// As [`count`].
pub fn record(plan: &Plan, layout: &str) -> Result<(usize, Recording), LabError> {
    let mut simulation = (plan.solver.build)(&plan.scene, layout)?;
    let steps = || (0..plan.steps).try_for_each(|_| simulation.step());
    let (done, recording) = probe::record(&plan.caches, steps).map_err(|error| match error {
        RecordError::Cache(why) => LabError::usage(why),
        other => LabError::failure(other.to_string()),
    })?;
    done.map_err(|error| LabError::failure(format!("{layout}: {error}")))?;
    Ok((simulation.bytes(), recording))
}
