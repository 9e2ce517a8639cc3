//! `allotrope report`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::scenes::{self, SceneArguments};
use super::values::{self, words};
use crate::lab::bench;
use crate::lab::counts::Report;
use crate::lab::errors::LabError;
use crate::lab::machine::NamedSchedule;
use crate::lab::report::{Plan, report};

/// The longest budget in seconds: a day.
const LONGEST: f64 = 86_400.0;

/// What is asked of `allotrope report`.
#[derive(Args, Debug)]
pub struct ReportArguments {
    /// The solver; `list` tells which there are
    solver: String,
    #[command(flatten)]
    what: SceneArguments,
    /// The layouts, with commas between them, or `all` that fit the scene
    #[arg(long, value_name = "A,B", default_value = "all")]
    layouts: String,
    /// How loops accumulate, with commas between: auto, serial, private, colored, atomic
    #[arg(long, value_name = "A,B", default_value = "auto")]
    schedules: String,
    /// About how many seconds the comparison takes, if no steps are asked for
    #[arg(long, value_name = "SECONDS", value_parser = values::positive, default_value_t = 20.0)]
    budget: f64,
    /// Compares at other sizes too, which takes about as long again
    #[arg(long)]
    sweep: bool,
    /// What `count --json` has written of this scene, to be shown too
    #[arg(long, value_name = "FILE")]
    counts: Option<PathBuf>,
    /// The folder for `report.html`
    #[arg(long, value_name = "DIR", default_value = "allotrope-report")]
    out: PathBuf,
}

impl ReportArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        let scene = self.what.scene(solver)?;
        if self.budget > LONGEST {
            return Err(LabError::usage(format!("`--budget {}` is longer than a day, {LONGEST} s", self.budget)));
        }
        let layouts = scenes::asked(solver, &scene, &self.layouts)?;
        let schedules: Result<Vec<_>, _> = words(&self.schedules).into_iter().map(NamedSchedule::find).collect();
        let schedules = schedules.map_err(LabError::usage)?;
        if layouts.is_empty() || schedules.is_empty() {
            return Err(LabError::usage("`--layouts` and `--schedules` each want at least one name"));
        }
        let file = self.counts.as_deref();
        let counts = file.map(|file| counts(file, solver.name, self.what.name(solver))).transpose()?;
        let (name, command, words) = (self.what.name(solver).to_string(), self.command(), self.what.words());
        let SceneArguments { threads, steps, .. } = self.what;
        let bench = bench::Plan { solver, name, scene, layouts, schedules, threads, steps, hardware: true };
        let Self { budget, sweep, out, .. } = self;
        report(&Plan { bench, scene: words, command, budget, sweep, counts, out })
    }

    /// The words of this command behind the program's name.
    fn command(&self) -> Vec<String> {
        let mut command = vec!["report".to_string(), self.solver.clone()];
        command.extend(self.what.words());
        let mut option = |name: &str, value: Option<String>| {
            if let Some(value) = value {
                command.extend([format!("--{name}"), value]);
            }
        };
        option("layouts", Some(self.layouts.clone()));
        option("schedules", Some(self.schedules.clone()));
        option("threads", self.what.threads.map(|threads| threads.to_string()));
        option("steps", self.what.steps.map(|steps| steps.to_string()));
        option("budget", self.what.steps.is_none().then(|| self.budget.to_string()));
        option("counts", self.counts.as_ref().map(|file| file.display().to_string()));
        option("out", Some(self.out.display().to_string()));
        command.extend(self.sweep.then(|| "--sweep".to_string()));
        command
    }
}

/// The counts of a file, which are of this scene.
fn counts(file: &Path, solver: &str, scene: &str) -> Result<Report, LabError> {
    let fault = |why: String| LabError::usage(format!("`{}` {why}", file.display()));
    let text = std::fs::read_to_string(file).map_err(|error| fault(format!("cannot be read: {error}")))?;
    let counts: Report = serde_json::from_str(&text)
        .map_err(|error| fault(format!("is not what `allotrope count --json` writes: {error}")))?;
    if (counts.solver.as_str(), counts.scene.as_str()) != (solver, scene) {
        return Err(fault(format!("has counts of {} {}, not of {solver} {scene}", counts.solver, counts.scene)));
    }
    Ok(counts)
}
