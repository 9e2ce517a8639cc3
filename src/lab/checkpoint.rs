//! What a run is gone on with: the state of its simulation, and what was asked for.
//!
//! A checkpoint is an `.npz` file: the arrays of the state, `checkpoint.json` (the [`Header`]) and `scene.toml`.

use std::path::{Path, PathBuf};

use allotrope_solvers::{Array, Simulation, State};
use serde::{Deserialize, Serialize};

use super::errors::LabError;
use super::export::npz::{self, Npz};
use super::output;
use super::run::Export;

/// The version of what this module writes.
pub const FORMAT: u32 = 2;

/// The name of a checkpoint in the folder of its run.
pub const FILE: &str = "checkpoint.npz";

const HEADER: &str = "checkpoint.json";
const SCENE: &str = "scene.toml";

/// What a checkpoint says beside the scene and the state.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Header {
    /// [`FORMAT`].
    pub format: u32,
    /// The version of the program.
    pub version: String,
    /// The solver.
    pub solver: String,
    /// The scene's name or file.
    pub scene: String,
    /// The folder of the files that the scene names; none for the files of the built-in scenes.
    pub folder: Option<PathBuf>,
    /// The layout.
    pub layout: String,
    /// The instruction set of loops.
    pub isa: String,
    /// Steps done.
    pub steps_done: u64,
    /// Frames written.
    pub frames_done: u64,
    /// Simulated seconds at each of them.
    #[serde(default)]
    pub frame_times: Vec<f64>,
    /// What was asked for.
    pub plan: Planned,
}

/// What was asked for, so that the run goes on to the same end.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Planned {
    /// When particles are sorted: steps, 0 for never, or `auto`.
    pub reorder: String,
    /// Steps to take, from the start on.
    pub steps: u64,
    /// Steps from one frame to the next.
    pub every: Option<u64>,
    /// Steps from one checkpoint to the next.
    pub checkpoint_every: Option<u64>,
    /// What the colours of particles tell, where it was said.
    pub shading: Option<String>,
    /// How the grid is accumulated.
    pub schedule: String,
    /// Threads, where so many were asked for.
    pub threads: Option<usize>,
    /// Whether results are the same bits for any number of threads.
    pub deterministic: bool,
    /// Particle files at each frame.
    pub export: Vec<Export>,
    /// Whether an animated GIF is made.
    pub gif: bool,
    /// Whether a film is made.
    pub mp4: bool,
    /// Whether a contact sheet is made, where it was said.
    pub sheet: Option<bool>,
}

/// A checkpoint that was read.
#[derive(Clone, Debug)]
pub struct Checkpoint {
    /// The file.
    pub path: PathBuf,
    /// What it says.
    pub header: Header,
    /// The scene's TOML.
    pub scene: String,
    arrays: Npz,
}

/// Writes a checkpoint in the place of the one that was there.
///
/// # Errors
/// If the file cannot be written.
pub fn save(path: &Path, header: &Header, scene: &str, state: &State) -> Result<(), LabError> {
    let text = serde_json::to_string_pretty(header).map_err(|error| LabError::failure(error.to_string()))?;
    output::write(path, &npz::write(&state.arrays, &[(HEADER, &text), (SCENE, scene)])?)
}

impl Checkpoint {
    /// Reads a checkpoint, every byte of which is checked against the sums in it.
    ///
    /// # Errors
    /// If it is none, is damaged, or was written by another version.
    pub fn load(path: &Path) -> Result<Self, LabError> {
        let fault = |why: &str| LabError::usage(format!("checkpoint `{}` {why}", path.display()));
        let bytes = std::fs::read(path).map_err(|error| fault(&format!("cannot be read: {error}")))?;
        let arrays = npz::read(&bytes).map_err(|why| fault(&why))?;
        let text = |name| arrays.texts.iter().find(|(known, _)| known == name).map(|(_, text)| text.as_str());
        let (Some(about), Some(scene)) = (text(HEADER), text(SCENE)) else {
            return Err(fault(&format!("is no checkpoint: `{HEADER}` or `{SCENE}` is missing in it")));
        };
        let value: serde_json::Value =
            serde_json::from_str(about).map_err(|error| fault(&format!("has a faulty `{HEADER}`: {error}")))?;
        // The versions first: another one may have other keys.
        for (key, here) in [("format", FORMAT.into()), ("version", env!("CARGO_PKG_VERSION").into())] {
            let here: serde_json::Value = here;
            if value[key] != here {
                let why = format!(
                    "does not fit: `{key}` is {here} here and {} there; go on with the program that wrote it",
                    value[key]
                );
                return Err(fault(&why));
            }
        }
        let header =
            serde_json::from_value(value).map_err(|error| fault(&format!("has a faulty `{HEADER}`: {error}")))?;
        let scene = scene.to_string();
        Ok(Self { path: path.to_path_buf(), header, scene, arrays })
    }

    /// That something here differs from what the checkpoint says.
    pub fn differs(&self, key: &str, there: &str, here: &str) -> LabError {
        LabError::usage(format!(
            "checkpoint `{}` does not fit: `{key}` is {here} here and {there} there; leave out what was not asked for \
             then, or start anew without `--resume`",
            self.path.display()
        ))
    }

    /// Sets a simulation, which has just been made of the same scene in the same layout, to the state.
    ///
    /// # Errors
    /// If the arrays are not those of such a simulation.
    pub fn restore(&self, simulation: &mut dyn Simulation) -> Result<(), LabError> {
        let fault = |why: String| LabError::usage(format!("checkpoint `{}` does not fit: {why}", self.path.display()));
        // The names of arrays are those of the program.
        let arrays = simulation.save().arrays.into_iter().map(|Array { name, components, .. }| {
            let known = self.arrays.arrays.iter().find(|(known, ..)| known == name);
            let (_, there, values) = known.ok_or_else(|| fault(format!("array `{name}` is missing")))?;
            if *there != components {
                let why = format!("array `{name}` has {components} values an element here and {there} there");
                return Err(fault(why));
            }
            Ok(Array { name, components, values: values.clone() })
        });
        let state = State { steps: self.header.steps_done, arrays: arrays.collect::<Result<_, _>>()? };
        simulation.restore(&state).map_err(fault)
    }

    /// The folder of the run.
    pub fn folder(&self) -> &Path {
        match self.path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        }
    }
}
