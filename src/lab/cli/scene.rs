//! `allotrope scene`.

use std::path::PathBuf;

use allotrope_solvers::{SolverInfo, solvers};
use clap::{Args, Subcommand};

use super::{examples, scenes};
use crate::lab::errors::LabError;
use crate::lab::{output, scene};

/// What is asked of `allotrope scene`.
#[derive(Debug, Subcommand)]
pub enum SceneCommand {
    /// Reads, fills and checks scenes, and tells a line about each
    #[command(after_help = examples::SCENE_CHECK)]
    Check(CheckArguments),
    /// Prints a scene as the solver sees it
    #[command(after_help = examples::SCENE_SHOW)]
    Show(ShowArguments),
}

/// What is asked of `allotrope scene check`.
#[derive(Args, Debug)]
pub struct CheckArguments {
    /// TOML files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
}

/// What is asked of `allotrope scene show`.
#[derive(Args, Debug)]
pub struct ShowArguments {
    /// A built-in name, or a TOML file
    #[arg(value_name = "SCENE")]
    scene: String,
    /// The solver whose built-in scene it is [default: the first that has one of this name]
    #[arg(long, value_name = "SOLVER")]
    solver: Option<String>,
    /// Another value than the scene's; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl SceneCommand {
    pub(super) fn execute(self) -> Result<(), LabError> {
        match self {
            Self::Check(arguments) => scene::check(&arguments.files),
            Self::Show(arguments) => arguments.execute(),
        }
    }
}

impl ShowArguments {
    fn execute(self) -> Result<(), LabError> {
        let has = |solver: &&SolverInfo| solver.scenes.iter().any(|scene| scene.name == self.scene);
        let of = match &self.solver {
            Some(name) => allotrope_solvers::solver(name).map_err(LabError::usage)?,
            None => solvers().iter().find(has).unwrap_or(&solvers()[0]),
        };
        let scene = scenes::named(of, &self.scene, &self.set)?;
        output::print(&format!("{}\n", scene.text.trim_end()))
    }
}
