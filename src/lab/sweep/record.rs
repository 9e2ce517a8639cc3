//! What a sweep has found so far, in files.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::{Axis, Plan, chart};
use crate::lab::bench::Report;
use crate::lab::errors::LabError;
use crate::lab::{machine, output};

/// The version of what this module writes.
const FORMAT: u32 = 1;

/// The file from which a sweep goes on.
pub const FILE: &str = "sweep.json";

/// What `sweep.json` holds.
#[derive(Debug, Deserialize, Serialize)]
pub struct Record {
    /// What was asked for, and where: a sweep goes on only with the same.
    #[serde(flatten)]
    head: Head,
    /// What was measured, in the order of the axis.
    pub points: Vec<Point>,
}

#[derive(Debug, Deserialize, PartialEq, Serialize)]
struct Head {
    format: u32,
    version: String,
    solver: String,
    scene: String,
    axis: Axis,
    layouts: Vec<String>,
    schedules: Vec<String>,
    threads: Option<usize>,
    steps: Option<u64>,
    reorder: String,
    processor: String,
    isa: String,
    /// The scene as a text.
    text: String,
}

/// What was measured with one value of the axis.
#[derive(Debug, Deserialize, Serialize)]
pub struct Point {
    /// The value.
    pub value: String,
    /// By how much positions differed between layouts, at most, before anything was timed.
    pub agreement: f64,
    /// The comparison.
    pub report: Report,
}

impl Record {
    /// Of a sweep that has not begun.
    pub(super) fn new(plan: &Plan) -> Self {
        let bench = &plan.bench;
        let head = Head {
            format: FORMAT,
            version: env!("CARGO_PKG_VERSION").to_string(),
            solver: bench.solver.name.to_string(),
            scene: bench.name.clone(),
            axis: plan.axis,
            layouts: bench.layouts.iter().map(|layout| layout.to_string()).collect(),
            schedules: bench.schedules.iter().map(|schedule| schedule.name.to_string()).collect(),
            threads: (plan.axis != Axis::Threads).then(|| machine::threads(bench.threads)),
            steps: bench.steps,
            reorder: bench.scene.reorder().to_string(),
            processor: machine::processor(),
            isa: machine::instruction_set(),
            text: bench.scene.text.clone(),
        };
        Self { head, points: Vec::new() }
    }

    /// The axis.
    pub fn axis(&self) -> Axis {
        self.head.axis
    }

    /// Solver and scene.
    pub(super) fn title(&self) -> String {
        format!("{} {}", self.head.solver, self.head.scene)
    }

    /// Processor, instruction set, and threads if they are not what changes.
    pub(super) fn machine(&self) -> String {
        let threads = match self.head.threads {
            None => String::new(),
            Some(1) => ", 1 thread".into(),
            Some(threads) => format!(", {threads} threads"),
        };
        format!("{}{threads}, {}", self.head.processor, self.head.isa)
    }

    /// Whether each layout was run with more than one schedule.
    pub(super) fn has_schedules(&self) -> bool {
        self.head.schedules.len() > 1
    }

    /// Takes over the points of a file, if it is of the same sweep.
    pub(super) fn take_over(&mut self, file: &Path) -> Result<(), LabError> {
        let fault = |why: String| LabError::usage(format!("sweep `{}` {why}", file.display()));
        let text = std::fs::read_to_string(file).map_err(|error| fault(format!("cannot be read: {error}")))?;
        let there: serde_json::Value =
            serde_json::from_str(&text).map_err(|error| fault(format!("is damaged: {error}")))?;
        let here = serde_json::to_value(&self.head).map_err(|error| LabError::failure(error.to_string()))?;
        let here = here.as_object().into_iter().flatten();
        if let Some((key, here)) = here.into_iter().find(|(key, here)| there[key.as_str()] != **here) {
            let other = if key == "text" {
                "the scene has other values".to_string()
            } else {
                format!("`{key}` is {here} here and {} there", there[key.as_str()])
            };
            return Err(fault(format!("is another one: {other}; take another folder by `--out`, or remove it")));
        }
        let there: Self = serde_json::from_value(there).map_err(|error| fault(format!("is damaged: {error}")))?;
        self.points = there.points;
        Ok(())
    }

    /// What was measured with a value.
    pub fn point(&self, value: &str) -> Option<&Point> {
        self.points.iter().find(|point| point.value == value)
    }

    pub(super) fn add(&mut self, point: Point) {
        self.points.push(point);
        self.points.sort_by(|a, b| self.head.axis.order(&a.value, &b.value));
    }

    /// Its chart, as the text of an SVG file.
    pub(in crate::lab) fn chart(&self) -> Result<String, LabError> {
        chart::svg(self)
    }

    /// Writes all files; the one from which the sweep goes on comes first.
    pub(super) fn write(&self, out: &Path) -> Result<(), LabError> {
        output::write(&out.join(FILE), output::line_of_json(self)?.as_bytes())?;
        output::write(&out.join("sweep.csv"), self.csv().as_bytes())?;
        output::write(&out.join("sweep.svg"), self.chart()?.as_bytes())
    }

    /// A line for each layout and schedule at each point.
    fn csv(&self) -> String {
        let mut text = format!(
            "{},particles,grid,threads,layout,schedule,ms_per_step,ns_per_particle,spread,bytes,state_error\n",
            self.head.axis.name()
        );
        for Point { value, report, .. } in &self.points {
            let grid: Vec<String> = report.grid.iter().map(usize::to_string).collect();
            for row in &report.rows {
                text += &format!(
                    "{value},{},{},{},{},{},{},{},{},{},{}\n",
                    report.particles,
                    grid.join("x"),
                    report.threads,
                    row.layout,
                    row.schedule,
                    row.ms_per_step,
                    row.ms_per_step * 1e6 / report.particles as f64,
                    row.spread,
                    row.bytes,
                    row.state_error
                );
            }
        }
        text
    }
}
