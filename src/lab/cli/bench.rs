//! `allotrope bench`.

use std::path::PathBuf;

use clap::Args;

use super::scenes::{self, SceneArguments};
use super::values::words;
use crate::lab::bench;
use crate::lab::errors::LabError;
use crate::lab::machine::NamedSchedule;
use crate::lab::search::Tuned;
use crate::lab::sweep::{self, Axis};

/// What is asked of `allotrope bench`.
#[derive(Args, Debug)]
pub struct BenchArguments {
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
    /// Layout, schedule and sorting as `search` found them
    #[arg(long, value_name = "FILE", conflicts_with_all = ["layouts", "schedules"])]
    tuned: Option<PathBuf>,
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Lets processor and system count too: cycles, instructions, misses; where they refuse, says so
    #[arg(long, conflicts_with = "sweep")]
    hardware: bool,
    /// Compares at many points, along one axis
    #[arg(long, value_enum, value_name = "AXIS", conflicts_with = "json")]
    sweep: Option<Axis>,
    /// The points of the sweep, with commas between them [default: some about the scene's]
    #[arg(long, value_name = "A,B", requires = "sweep")]
    points: Option<String>,
    /// The folder for `sweep.json`, `sweep.csv` and `sweep.svg`, in which an interrupted sweep goes on [default:
    /// allotrope-sweep]
    #[arg(long, value_name = "DIR", requires = "sweep")]
    out: Option<PathBuf>,
}

/// The folder of a sweep, if none is asked for.
const OUT: &str = "allotrope-sweep";

impl BenchArguments {
    pub(super) fn execute(mut self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        if let Some(file) = &self.tuned {
            let choice = Tuned::load(file, solver.name)?;
            self.what.tuned(file, &choice)?;
            (self.layouts, self.schedules) = (choice.layout, choice.schedule);
        }
        let scene = self.what.scene(solver)?;
        let layouts = if self.layouts.trim() == "all" && self.sweep == Some(Axis::Size) {
            // Which ones fit may depend on the size.
            solver.layouts.iter().map(|layout| layout.name).collect()
        } else {
            scenes::asked(solver, &scene, &self.layouts)?
        };
        let schedules: Result<Vec<_>, _> = words(&self.schedules).into_iter().map(NamedSchedule::find).collect();
        let schedules = schedules.map_err(LabError::usage)?;
        if layouts.is_empty() || schedules.is_empty() {
            return Err(LabError::usage("`--layouts` and `--schedules` each want at least one name"));
        }
        let name = self.what.name(solver).to_string();
        let plan = bench::Plan {
            solver,
            name,
            scene,
            layouts,
            schedules,
            threads: self.what.threads,
            steps: self.what.steps,
            hardware: self.hardware,
        };
        match self.sweep {
            Some(axis) => self.sweep(axis, plan),
            None => bench::bench(&plan, self.json.as_deref()),
        }
    }

    fn sweep(&self, axis: Axis, bench: bench::Plan) -> Result<(), LabError> {
        let SceneArguments { particles, threads, reorder, .. } = &self.what;
        let (option, twice) = match axis {
            Axis::Size | Axis::ParticlesPerCell => ("particles", particles.is_some()),
            // The grid that the scene has tells how large cells are.
            Axis::Sparsity => ("grid", false),
            Axis::Threads => ("threads", threads.is_some()),
            Axis::Order => ("reorder", reorder.is_some()),
        };
        // With points of its own it is what the sweep begins with.
        if twice && self.points.is_none() {
            return Err(LabError::usage(format!(
                "`--{option}` is what `--sweep {}` changes; leave it out, or ask for `--points`",
                axis.name()
            )));
        }
        let points = match &self.points {
            Some(points) if words(points).is_empty() => {
                return Err(LabError::usage("`--points` wants at least one value"));
            }
            points => points.iter().flat_map(|points| words(points)).map(String::from).collect(),
        };
        let out = self.out.clone().unwrap_or_else(|| OUT.into());
        sweep::sweep(&sweep::Plan { bench, axis, points }, &out)
    }
}
