//! `allotrope compare`.

use std::path::PathBuf;

use allotrope_solvers::nearest;
use clap::{Args, Subcommand};

use super::examples;
use super::values::{self, words};
use crate::lab::errors::LabError;
use crate::lab::peers::{self, Plan, WORKLOADS, Workload};

/// What is asked of `allotrope compare`.
#[derive(Debug, Subcommand)]
pub enum CompareCommand {
    /// Runs our workloads and Taichi's in turn, and compares their times
    #[command(after_help = examples::COMPARE_TAICHI)]
    Taichi(TaichiArguments),
}

/// What is asked of `allotrope compare taichi`.
#[derive(Args, Debug)]
pub struct TaichiArguments {
    /// The Python interpreter that has Taichi
    #[arg(long, value_name = "PATH", default_value = "python3")]
    python: PathBuf,
    /// The workloads, with commas between them, or `all`
    #[arg(long, value_name = "A,B", default_value = "all")]
    workloads: String,
    /// Threads of both sides [default: ALLOTROPE_THREADS, or as many as the processor runs]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    threads: Option<usize>,
    /// How often each side is timed, in turn
    #[arg(long, value_name = "N", default_value = "7", value_parser = clap::value_parser!(u16).range(5..=1000))]
    pairs: u16,
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl CompareCommand {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let Self::Taichi(TaichiArguments { python, workloads, threads, pairs, json }) = self;
        let workloads = match workloads.trim() {
            "all" => WORKLOADS.iter().collect(),
            some => words(some).into_iter().map(workload).collect::<Result<Vec<_>, _>>()?,
        };
        if workloads.is_empty() {
            return Err(LabError::usage("`--workloads` wants at least one name"));
        }
        let plan = Plan { workloads, python, threads, pairs: usize::from(pairs) };
        peers::compare_taichi(&plan, json.as_deref())
    }
}

fn workload(name: &str) -> Result<&'static Workload, LabError> {
    let names = WORKLOADS.iter().map(|workload| workload.name);
    WORKLOADS.iter().find(|workload| workload.name == name).ok_or_else(|| {
        let hint = match nearest(name, names.clone()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are `{}`", names.collect::<Vec<_>>().join("`, `")),
        };
        LabError::usage(format!("there is no workload `{name}`; {hint}"))
    })
}
