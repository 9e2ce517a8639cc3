//! `allotrope bench`.

use std::path::PathBuf;

use clap::Args;

use super::scenes::{self, SceneArguments};
use super::values::words;
use crate::lab::bench;
use crate::lab::errors::LabError;
use crate::lab::machine::NamedSchedule;

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
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl BenchArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        let scene = self.what.scene(solver)?;
        let layouts = if self.layouts.trim() == "all" {
            scenes::fit(solver, &scene)
        } else {
            let named = words(&self.layouts).into_iter().map(|name| scenes::fitting(solver, &scene, Some(name)));
            named.collect::<Result<_, _>>()?
        };
        let schedules: Result<Vec<_>, _> = words(&self.schedules).into_iter().map(NamedSchedule::find).collect();
        let schedules = schedules.map_err(LabError::usage)?;
        if layouts.is_empty() || schedules.is_empty() {
            return Err(LabError::usage("`--layouts` and `--schedules` each want at least one name"));
        }
        let name = self.what.name(solver).to_string();
        let plan =
            bench::Plan { solver, name, scene, layouts, schedules, threads: self.what.threads, steps: self.what.steps };
        bench::bench(&plan, self.json.as_deref())
    }
}
