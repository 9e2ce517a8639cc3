//! `allotrope count`.

use std::path::PathBuf;

use allotrope::probe::{Cache, Caches};
use clap::Args;

use super::scenes::{self, SceneArguments};
use super::values;
use crate::lab::counts;
use crate::lab::errors::LabError;

/// What is asked of `allotrope count`.
#[derive(Args, Debug)]
pub struct CountArguments {
    /// The solver; `list` tells which there are
    solver: String,
    #[command(flatten)]
    what: SceneArguments,
    /// The layouts, with commas between them, or `all` that fit the scene
    #[arg(long, value_name = "A,B", default_value = "all")]
    layouts: String,
    /// The first modelled cache: KiB and ways
    #[arg(long, value_name = "KIB,WAYS", value_parser = values::cache)]
    first_level: Option<Cache>,
    /// The second modelled cache: KiB and ways
    #[arg(long, value_name = "KIB,WAYS", value_parser = values::cache)]
    second_level: Option<Cache>,
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// A folder for pictures of how often each cache line of each field was touched
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl CountArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        let scene = self.what.scene(solver)?;
        let layouts = scenes::asked(solver, &scene, &self.layouts)?;
        if layouts.is_empty() {
            return Err(LabError::usage("`--layouts` wants at least one name"));
        }
        if self.what.threads.is_some_and(|threads| threads != 1) {
            return Err(LabError::usage("accesses are counted on one thread, so that their order is always the same"));
        }
        let name = self.what.name(solver).to_string();
        let usual = Caches::default();
        let caches = Caches {
            first: self.first_level.unwrap_or(usual.first),
            second: self.second_level.unwrap_or(usual.second),
        };
        let plan = counts::Plan { solver, name, scene, layouts, steps: self.what.steps.unwrap_or(1), caches };
        counts::count(&plan, self.json.as_deref(), self.out.as_deref())
    }
}
