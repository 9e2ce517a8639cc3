//! `allotrope run`.

use std::path::{Path, PathBuf};

use allotrope_solvers::scene::Folder;
use allotrope_solvers::{Scene, SolverInfo};
use clap::{Args, ValueEnum};

use super::scenes::{self, SceneArguments};
use super::values;
use crate::lab::checkpoint::Checkpoint;
use crate::lab::errors::LabError;
use crate::lab::machine::NamedSchedule;
use crate::lab::render::Shading;
use crate::lab::run::{self, Calendar, Export, Outputs, Plan, Progress, check};
use crate::lab::search::Tuned;

/// The folder for files, if none is asked for.
const OUT: &str = "allotrope-out";

/// Pictures of a run, if their number is not asked for.
const FRAMES: u64 = 60;

/// What makes no sense of a check, which takes the steps that it needs and writes nothing.
const NOT_CHECKED: [&str; 15] = [
    "steps",
    "frames",
    "every",
    "out",
    "shading",
    "azimuth",
    "elevation",
    "zoom",
    "gif",
    "mp4",
    "sheet",
    "no_sheet",
    "export",
    "checkpoint_every",
    "resume",
];

/// What is asked of `allotrope run`.
#[derive(Args, Debug)]
pub struct RunArguments {
    /// The solver; `list` tells which there are
    #[arg(required_unless_present = "resume")]
    solver: Option<String>,
    #[command(flatten)]
    what: SceneArguments,
    /// The layout; of solvers with a grid, particles+grid [default: the first that fits the scene]
    #[arg(long, value_name = "L")]
    layout: Option<String>,
    /// How loops accumulate: auto, serial, private, colored or atomic [default: auto]
    #[arg(long, value_name = "S")]
    schedule: Option<String>,
    /// Layout, schedule and sorting as `search` found them, where no option tells otherwise
    #[arg(long, value_name = "FILE", conflicts_with = "resume")]
    tuned: Option<PathBuf>,
    /// The same bits for any number of threads, at some cost
    #[arg(long)]
    deterministic: bool,
    /// Pictures to write, from the start to the end, 0 for none [default: 60]
    #[arg(long, value_name = "N", conflicts_with = "every")]
    #[arg(value_parser = clap::value_parser!(u64).range(0..=1_000_000))]
    frames: Option<u64>,
    /// Steps from one picture to the next, instead of `--frames`
    #[arg(long, value_name = "N", value_parser = values::steps)]
    every: Option<u64>,
    /// The folder for all files; it is made if it is not there [default: allotrope-out]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// What the colours of particles tell: velocity, material or pressure [default: material where there are several]
    #[arg(long, value_name = "S")]
    shading: Option<String>,
    /// Degrees around the vertical axis, from which a scene in space is looked at
    #[arg(long, value_name = "A", value_parser = values::finite, allow_negative_numbers = true)]
    azimuth: Option<f64>,
    /// Degrees above the horizon
    #[arg(long, value_name = "A", value_parser = values::finite, allow_negative_numbers = true)]
    elevation: Option<f64>,
    /// How much nearer than where the whole is seen
    #[arg(long, value_name = "F", value_parser = values::positive)]
    zoom: Option<f64>,
    /// Makes an animated GIF of the pictures, `animation.gif`
    #[arg(long)]
    gif: bool,
    /// Makes a film of the pictures, `animation.mp4`, where ffmpeg is installed
    #[arg(long)]
    mp4: bool,
    /// Makes a contact sheet of the pictures, `sheet.png` [default: where there are two or more]
    #[arg(long, overrides_with = "no_sheet")]
    sheet: bool,
    /// Makes no contact sheet
    #[arg(long, overrides_with = "sheet")]
    no_sheet: bool,
    /// Files of the particles at each frame, with commas between: ply, npz, vtk (with the grid)
    #[arg(long, value_name = "A,B", value_delimiter = ',')]
    export: Vec<Export>,
    /// Steps after which `checkpoint.npz` is written, and written anew
    #[arg(long, value_name = "N", value_parser = values::steps)]
    checkpoint_every: Option<u64>,
    /// Goes on from a checkpoint, to the end and in the folder of its run; other options must agree with it
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Checks the scene's numbers against published ones or closed forms, instead of making pictures
    #[arg(long, conflicts_with_all = NOT_CHECKED)]
    check: bool,
    /// How to tell of the progress
    #[arg(long, value_enum, value_name = "P", default_value_t)]
    progress: Progress,
    /// Tells nothing but errors
    #[arg(long)]
    quiet: bool,
}

fn shading(name: Option<&str>) -> Result<Option<Shading>, LabError> {
    name.map(Shading::find).transpose().map_err(LabError::usage)
}

/// The names of what is exported.
fn listed(export: &[Export]) -> String {
    let names: Vec<_> = export.iter().map(|export| export.name()).collect();
    if names.is_empty() { "none".into() } else { names.join(",") }
}

impl RunArguments {
    pub(super) fn execute(mut self) -> Result<(), LabError> {
        if let Some(file) = &self.tuned {
            let choice = Tuned::load(file, self.solver.as_deref().unwrap_or_default())?;
            self.what.tuned(file, &choice)?;
            self.layout.get_or_insert(choice.layout);
            self.schedule.get_or_insert(choice.schedule);
        }
        if self.check {
            return self.check();
        }
        let checkpoint = self.resume.as_deref().map(Checkpoint::load).transpose()?;
        let plan = match &checkpoint {
            Some(checkpoint) => self.resumed(checkpoint)?,
            None => self.fresh()?,
        };
        run::run(&plan, checkpoint.as_ref(), self.progress, self.quiet)
    }

    fn solver(&self) -> Result<&'static SolverInfo, LabError> {
        // The parser asks for it where it is needed.
        allotrope_solvers::solver(self.solver.as_deref().unwrap_or_default()).map_err(LabError::usage)
    }

    fn schedule(&self) -> Result<NamedSchedule, LabError> {
        NamedSchedule::find(self.schedule.as_deref().unwrap_or("auto")).map_err(LabError::usage)
    }

    fn check(&self) -> Result<(), LabError> {
        let solver = self.solver()?;
        let scene = self.what.scene(solver)?;
        let gate = check::gate(solver, self.what.name(solver))?;
        let layout = scenes::fitting(solver, &scene, self.layout.as_deref())?;
        let schedule = self.schedule()?.with_threads(self.what.threads);
        let schedule = allotrope::Schedule { deterministic: self.deterministic, ..schedule };
        let mut simulation = (solver.build)(&scene, layout)?;
        check::check(&mut *simulation, &mut *gate(&scene)?, schedule, self.progress, self.quiet)
    }

    /// What is set of the scene by options of their own.
    fn camera(&self) -> Vec<String> {
        let turns = [("azimuth", self.azimuth), ("elevation", self.elevation), ("zoom", self.zoom)];
        turns.into_iter().filter_map(|(key, value)| Some(format!("camera.{key}={:?}", value?))).collect()
    }

    fn sheet(&self) -> Option<bool> {
        (self.sheet || self.no_sheet).then_some(self.sheet)
    }

    fn export(&self) -> Vec<Export> {
        Export::value_variants().iter().copied().filter(|export| self.export.contains(export)).collect()
    }

    /// A run from the start.
    fn fresh(&self) -> Result<Plan, LabError> {
        let solver = self.solver()?;
        let name = self.what.name(solver);
        let scene = self.what.scene_with(solver, &self.camera())?;
        let layout = scenes::fitting(solver, &scene, self.layout.as_deref())?;
        let steps = self.what.steps.unwrap_or(scene.steps);
        let export = self.export();
        if self.frames == Some(0) && (self.gif || self.mp4 || self.sheet || !export.is_empty()) {
            return Err(LabError::usage(
                "`--frames 0` asks for no frames, of which `--gif`, `--mp4`, `--sheet` or `--export` would be made",
            ));
        }
        let every = match (self.every, self.frames) {
            (Some(every), _) => Some(every),
            (None, Some(0)) => None,
            (None, frames) => Some(steps.div_ceil(frames.unwrap_or(FRAMES))),
        };
        Ok(Plan {
            solver,
            scene_folder: scenes::folder(solver, name)?,
            scene,
            layout,
            schedule: self.schedule()?,
            threads: self.what.threads,
            deterministic: self.deterministic,
            calendar: Calendar { steps, every, checkpoint_every: self.checkpoint_every },
            outputs: Outputs {
                shading: shading(self.shading.as_deref())?,
                export,
                gif: self.gif,
                mp4: self.mp4,
                sheet: self.sheet(),
            },
            out: self.out.clone().unwrap_or_else(|| OUT.into()),
        })
    }

    /// The rest of a run.
    fn resumed(&self, checkpoint: &Checkpoint) -> Result<Plan, LabError> {
        let (header, there) = (&checkpoint.header, &checkpoint.header.plan);
        self.agrees(checkpoint)?;
        let solver = allotrope_solvers::solver(&header.solver).map_err(LabError::usage)?;
        let scene = self.same_scene(solver, checkpoint)?;
        let steps = self.what.steps.unwrap_or(there.steps);
        if steps < header.steps_done {
            return Err(LabError::usage(format!(
                "`--steps {steps}` are fewer than the {} that are done in checkpoint `{}`",
                header.steps_done,
                checkpoint.path.display()
            )));
        }
        Ok(Plan {
            solver,
            scene_folder: header.folder.clone(),
            layout: scenes::fitting(solver, &scene, Some(&header.layout))?,
            scene,
            schedule: NamedSchedule::find(&there.schedule).map_err(LabError::usage)?,
            threads: self.what.threads.or(there.threads),
            deterministic: there.deterministic,
            calendar: Calendar {
                steps,
                every: there.every,
                checkpoint_every: self.checkpoint_every.or(there.checkpoint_every),
            },
            outputs: Outputs {
                shading: shading(there.shading.as_deref())?,
                export: there.export.clone(),
                gif: there.gif || self.gif,
                mp4: there.mp4 || self.mp4,
                sheet: self.sheet().or(there.sheet),
            },
            out: self.same_folder(checkpoint)?,
        })
    }

    /// That what was asked for now was asked for then. Threads, films and when checkpoints are written may change.
    fn agrees(&self, checkpoint: &Checkpoint) -> Result<(), LabError> {
        let (header, there) = (&checkpoint.header, &checkpoint.header.plan);
        let agree = |key: &str, there: &str, here: Option<&str>| match here {
            Some(here) if here != there => Err(checkpoint.differs(key, there, here)),
            _ => Ok(()),
        };
        agree("solver", &header.solver, self.solver.as_deref())?;
        agree("layout", &header.layout, self.layout.as_deref())?;
        let number = |value: Option<u64>| value.map_or("not set".to_string(), |value| value.to_string());
        agree("reorder", &there.reorder, self.what.reorder.map(|here| here.to_string()).as_deref())?;
        let pictures = match (self.every, self.frames) {
            (Some(every), _) => Some(Some(every)),
            (None, Some(0)) => Some(None),
            (None, Some(frames)) => Some(Some(self.what.steps.unwrap_or(there.steps).div_ceil(frames))),
            (None, None) => None,
        };
        agree("every", &number(there.every), pictures.map(number).as_deref())?;
        agree("shading", there.shading.as_deref().unwrap_or("not set"), self.shading.as_deref())?;
        agree("schedule", &there.schedule, self.schedule.as_deref())?;
        agree("deterministic", &there.deterministic.to_string(), self.deterministic.then_some("true"))?;
        let export = (!self.export.is_empty()).then(|| listed(&self.export()));
        agree("export", &listed(&there.export), export.as_deref())
    }

    /// The scene of the checkpoint; what is asked for too must be the same.
    fn same_scene(&self, solver: &SolverInfo, checkpoint: &Checkpoint) -> Result<Scene, LabError> {
        let header = &checkpoint.header;
        let read = |set: &[String]| {
            let folder = header.folder.clone().map_or(Folder::BuiltIn, Folder::Path);
            Scene::parse_with(&checkpoint.scene, &header.scene, folder, set)
        };
        let there = read(&[])?;
        let camera = self.camera();
        let here = match &self.what.scene {
            Some(_) => self.what.scene_with(solver, &camera)?,
            None => self.what.sized(read(&[&self.what.set[..], &camera].concat())?)?,
        };
        if let Some(difference) = here.difference(&checkpoint.scene) {
            return Err(self.other_scene(checkpoint, &difference));
        }
        // From where it is looked at is no part of the scene, but of its pictures.
        for (key, asked, there) in [
            ("azimuth", self.azimuth, there.camera.azimuth),
            ("elevation", self.elevation, there.camera.elevation),
            ("zoom", self.zoom, there.camera.zoom),
        ] {
            if let Some(here) = asked.filter(|here| *here != there) {
                return Err(checkpoint.differs(key, &there.to_string(), &here.to_string()));
            }
        }
        let reorder = header.plan.reorder.parse().map_err(|fault| {
            LabError::usage(format!("checkpoint `{}`: `reorder`: {fault}", checkpoint.path.display()))
        })?;
        Ok(there.with_reorder(reorder)?)
    }

    fn other_scene(&self, checkpoint: &Checkpoint, difference: &str) -> LabError {
        LabError::usage(format!(
            "checkpoint `{}` is of another scene: {difference}; leave out what was not asked for then, or start anew \
             without `--resume`",
            checkpoint.path.display()
        ))
    }

    /// The folder of the checkpoint; one that is asked for too must be the same.
    fn same_folder(&self, checkpoint: &Checkpoint) -> Result<PathBuf, LabError> {
        let folder = checkpoint.folder();
        let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        match &self.out {
            Some(out) if real(out) != real(folder) => Err(LabError::usage(format!(
                "`--out {}` is not the folder of checkpoint `{}`, in which the run goes on; leave it out",
                out.display(),
                checkpoint.path.display()
            ))),
            _ => Ok(folder.to_path_buf()),
        }
    }
}
