//! `allotrope convert-cost`.

use std::path::PathBuf;

use clap::Args;

use super::scenes::{self, SceneArguments};
use crate::lab::convert_cost::{Plan, convert_cost};
use crate::lab::errors::LabError;
use crate::lab::machine::NamedSchedule;

/// What is asked of `allotrope convert-cost`.
#[derive(Args, Debug)]
pub struct ConvertCostArguments {
    /// The solver; `list` tells which there are
    solver: String,
    /// The layout in which a run is
    #[arg(value_name = "A")]
    from: String,
    /// The layout in which it may go on
    #[arg(value_name = "B")]
    to: String,
    #[command(flatten)]
    what: SceneArguments,
    /// How loops accumulate: auto, serial, private, colored or atomic
    #[arg(long, value_name = "S", default_value = "auto")]
    schedule: String,
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl ConvertCostArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        let scene = self.what.scene(solver)?;
        let from = scenes::fitting(solver, &scene, Some(&self.from))?;
        let to = scenes::fitting(solver, &scene, Some(&self.to))?;
        if from == to {
            return Err(LabError::usage(format!("`{from}` is changed into itself; ask for two layouts")));
        }
        let schedule = NamedSchedule::find(&self.schedule).map_err(LabError::usage)?;
        let name = self.what.name(solver).to_string();
        let (threads, steps) = (self.what.threads, self.what.steps);
        let plan = Plan { solver, name, scene, layouts: [from, to], schedule, threads, steps };
        convert_cost(&plan, self.json.as_deref())
    }
}
