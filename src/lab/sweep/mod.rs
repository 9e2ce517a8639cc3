//! `allotrope bench --sweep`: the comparison of layouts for many sizes, numbers of threads or orders of particles.
//!
//! After each point its results are on the disk, and a sweep that was interrupted goes on after them.

mod axis;
mod chart;
mod record;
mod text;

use std::path::Path;

pub use axis::Axis;
use axis::Start;
pub use record::{FILE, Point, Record};

use super::bench::{self, measure};
use super::errors::LabError;
use super::output;

/// What is to be swept.
#[derive(Debug)]
pub struct Plan {
    /// What is compared at each point. Layouts that do not fit a point are left out there.
    pub bench: bench::Plan,
    /// What changes from point to point.
    pub axis: Axis,
    /// Its values; if none are given, some about those of the scene.
    pub points: Vec<String>,
}

/// Sweeps, tells the best of each point, prints a table, and writes `sweep.json`, `sweep.csv` and `sweep.svg` into a folder.
/// Points that are in its `sweep.json` already, from the same command, are not measured again.
///
/// # Errors
/// If a value cannot be, the folder holds another sweep, a point cannot be measured, or a file cannot be written.
pub fn sweep(plan: &Plan, out: &Path) -> Result<(), LabError> {
    let Plan { bench, axis, .. } = plan;
    let start = Start::new(bench, *axis)?;
    let points = if plan.points.is_empty() { axis.usual(&start) } else { plan.points.clone() };
    for value in &points {
        axis.check(value)?;
        start.point(bench, *axis, value)?;
    }
    output::folder(out)?;
    let file = out.join(FILE);
    let mut record = Record::new(plan);
    if file.exists() {
        record.take_over(&file)?;
    }
    let missing: Vec<&String> = points.iter().filter(|value| record.point(value).is_none()).collect();
    let done = points.len() - missing.len();
    output::print(&format!("{}\n", text::start(&record, points.len(), done)))?;
    for (n, value) in missing.into_iter().enumerate() {
        let (point, left_out) = measured(&start, plan, value)?;
        record.add(point);
        record.write(out)?;
        output::print(&text::point(&record, value, done + n + 1, points.len(), &left_out))?;
    }
    // Also of a sweep that was whole already.
    record.write(out)?;
    output::print(&text::table(&record, out))
}

/// The point of a value, and the layouts that do not fit it.
fn measured(
    start: &Start,
    Plan { bench, axis, .. }: &Plan,
    value: &str,
) -> Result<(Point, Vec<&'static str>), LabError> {
    let point = start.point(bench, *axis, value)?;
    let (fit, unfit): (Vec<_>, Vec<_>) =
        point.layouts.iter().partition(|layout| (point.solver.unfit)(&point.scene, layout).is_none());
    if fit.is_empty() {
        return Err(LabError::usage(format!("no layout fits the scene with {}", axis.named(value))));
    }
    let (report, about) = measure(&bench::Plan { layouts: fit, ..point })?;
    Ok((Point { value: value.into(), agreement: about.agreement, report }, unfit))
}

/// A sweep in memory, of which nothing is written or told: its points are checked before the first is measured.
pub(super) struct Unwritten {
    plan: Plan,
    start: Start,
}

impl Unwritten {
    /// The usual points along an axis.
    ///
    /// # Errors
    /// If the scene has nothing that could change along it, or cannot be so at a point.
    pub(super) fn new(bench: bench::Plan, axis: Axis) -> Result<Self, LabError> {
        let start = Start::new(&bench, axis)?;
        let points = axis.usual(&start);
        points.iter().try_for_each(|value| start.point(&bench, axis, value).map(|_| ()))?;
        Ok(Self { plan: Plan { bench, axis, points }, start })
    }

    /// The values of its points.
    pub(super) fn points(&self) -> &[String] {
        &self.plan.points
    }

    /// Measures all points, each over so many steps.
    ///
    /// # Errors
    /// If one cannot be measured.
    pub(super) fn record(mut self, steps: u64) -> Result<Record, LabError> {
        self.plan.bench.steps = Some(steps);
        let mut record = Record::new(&self.plan);
        for value in &self.plan.points {
            record.add(measured(&self.start, &self.plan, value)?.0);
        }
        Ok(record)
    }
}
