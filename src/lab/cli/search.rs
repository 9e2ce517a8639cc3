//! `allotrope search`.

use std::path::PathBuf;
use std::time::Duration;

use allotrope_solvers::scene::Reorder;
use clap::Args;

use super::scenes::{self, SceneArguments};
use super::values::{self, words};
use crate::lab::errors::LabError;
use crate::lab::machine::{self, NamedSchedule, SCHEDULES};
use crate::lab::search;

/// The longest budget in seconds: a day.
const LONGEST: f64 = 86_400.0;

/// What is asked of `allotrope search`.
#[derive(Args, Debug)]
pub struct SearchArguments {
    /// The solver; `list` tells which there are
    solver: String,
    #[command(flatten)]
    what: SceneArguments,
    /// About how many seconds it may take; longer where steps are long
    #[arg(long, value_name = "SECONDS", value_parser = values::positive, default_value_t = 30.0)]
    budget: f64,
    /// The layouts, with commas between them, or `all` that fit the scene
    #[arg(long, value_name = "A,B", default_value = "all")]
    layouts: String,
    /// How loops accumulate, with commas between them, or `all`: on one thread all of them add alike, and `auto` stands for them
    #[arg(long, value_name = "A,B", default_value = "all")]
    schedules: String,
    /// When particles are sorted, with commas between: numbers of steps, 0 for never, `auto`; of solvers that sort [default: 0,16,64,auto]
    #[arg(long, value_name = "A,B")]
    intervals: Option<String>,
    /// Lets all candidates run to the end instead of dropping the slower half after each round
    #[arg(long)]
    exhaustive: bool,
    /// Writes the best to a file, which `run` and `bench` take by `--tuned`
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl SearchArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let solver = allotrope_solvers::solver(&self.solver).map_err(LabError::usage)?;
        let scene = self.what.scene(solver)?;
        let SceneArguments { threads, steps, reorder, .. } = self.what;
        if steps.is_some() || reorder.is_some() {
            let (option, instead) = if steps.is_some() { ("steps", "budget") } else { ("reorder", "intervals") };
            return Err(LabError::usage(format!("`--{option}` makes no sense of a search; `--{instead}` does")));
        }
        if self.budget > LONGEST {
            return Err(LabError::usage(format!("`--budget {}` is longer than a day, {LONGEST} s", self.budget)));
        }
        let layouts = if self.layouts.trim() == "all" {
            scenes::fit(solver, &scene)
        } else {
            let named = words(&self.layouts).into_iter().map(|name| scenes::fitting(solver, &scene, Some(name)));
            named.collect::<Result<_, _>>()?
        };
        let schedules = match self.schedules.trim() {
            "all" if machine::threads(threads) == 1 => vec![SCHEDULES[0]],
            "all" => SCHEDULES.to_vec(),
            some => {
                let named: Result<Vec<_>, _> = words(some).into_iter().map(NamedSchedule::find).collect();
                named.map_err(LabError::usage)?
            }
        };
        let reorders = self.reorders(&scene)?;
        if layouts.is_empty() || schedules.is_empty() || reorders.is_empty() {
            return Err(LabError::usage("`--layouts`, `--schedules` and `--intervals` each want at least one value"));
        }
        let name = self.what.name(solver).to_string();
        let budget = Duration::from_secs_f64(self.budget);
        let exhaustive = self.exhaustive;
        let plan = search::Plan { solver, name, scene, layouts, schedules, reorders, threads, budget, exhaustive };
        search::search(&plan, self.out.as_deref())
    }

    /// When particles may be sorted.
    fn reorders(&self, scene: &allotrope_solvers::Scene) -> Result<Vec<Reorder>, LabError> {
        let Some(asked) = &self.intervals else {
            let some = || vec![Reorder::Never, Reorder::Every(16), Reorder::Every(64), Reorder::Decayed];
            return Ok(if scene.setup.sorts() { some() } else { vec![scene.reorder()] });
        };
        if !scene.setup.sorts() {
            return Err(LabError::usage(format!("`--intervals` makes no sense: `{}` sorts nothing", self.solver)));
        }
        let read = |word: &str| word.parse().map_err(|why| LabError::usage(format!("`--intervals {word}`: {why}")));
        words(asked).into_iter().map(read).collect()
    }
}
