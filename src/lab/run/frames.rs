//! Frames of a run: pictures, and files of particles.

use std::path::{Path, PathBuf};

use allotrope_solvers::Simulation;
use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::Plan;
use super::progress::Reporter;
use crate::lab::errors::LabError;
use crate::lab::export::gif::Gif;
use crate::lab::export::sheet::{self, Sheet};
use crate::lab::export::{mp4, npz, ply, vtk};
use crate::lab::output;
use crate::lab::render::{Camera, Picture, Shading};

/// Pictures of a film a second.
const PACE: f64 = 20.0;

/// What is made of each frame beside its picture.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Export {
    /// Particles for viewers of point clouds
    Ply,
    /// Particles for NumPy
    Npz,
    /// Particles and grid for ParaView
    Vtk,
}

impl Export {
    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ply => "ply",
            Self::Npz => "npz",
            Self::Vtk => "vtk",
        }
    }
}

/// What is made of the frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outputs {
    /// What the colours of particles tell, where it was said.
    pub shading: Option<Shading>,
    /// Files beside each picture.
    pub export: Vec<Export>,
    /// Whether an animated GIF is made of the pictures.
    pub gif: bool,
    /// Whether a film is made of them.
    pub mp4: bool,
    /// Whether a contact sheet is made of them; if nothing was said, where there are two or more.
    pub sheet: Option<bool>,
}

/// Writes frames, and at the end what is made of all of them.
pub(super) struct Frames<'a> {
    plan: &'a Plan,
    camera: Camera,
    /// Frames that there are.
    count: u64,
    /// Simulated seconds at each of them.
    times: Vec<f64>,
    /// Whether there is a grid, of which files can be made.
    grid: bool,
    /// The picture that was written last.
    picture: Option<PathBuf>,
    /// Its other files.
    exports: Vec<PathBuf>,
}

/// The files of a frame.
pub(super) struct LastFrame<'a> {
    pub(super) picture: &'a Path,
    pub(super) exports: &'a [PathBuf],
}

impl<'a> Frames<'a> {
    /// For a simulation that has just begun.
    pub(super) fn new(simulation: &dyn Simulation, plan: &'a Plan) -> Self {
        let shading = plan.outputs.shading.unwrap_or_else(|| Shading::fitting(simulation));
        let camera = Camera::new(simulation, &plan.scene, shading);
        let grid = !simulation.grid_shape().is_empty();
        Self { plan, camera, count: 0, times: Vec::new(), grid, picture: None, exports: Vec::new() }
    }

    /// Goes on after `count` frames of the same run, which were made at these times; a time that is not told is that of
    /// steps that are all alike.
    ///
    /// # Errors
    /// If one of them is not in the folder, and wanted for what is made of all.
    pub(super) fn already(&mut self, count: u64, times: &[f64]) -> Result<(), LabError> {
        let Outputs { gif, mp4, sheet, .. } = self.plan.outputs;
        let last = self.plan.calendar.frames(self.plan.calendar.steps);
        let wanted = gif || mp4 || sheet.unwrap_or(last > 1);
        let mut earlier = (0..count).map(|frame| self.picture(frame));
        if let Some(missing) = earlier.find(|picture| wanted && !picture.is_file()) {
            return Err(LabError::usage(format!(
                "picture `{}` of the earlier part is missing, and would be in the contact sheet or the film; put \
                     it back, or start anew without `--resume`",
                missing.display()
            )));
        }
        let alike = |frame: u64| self.plan.calendar.step(frame) as f64 * self.plan.scene.dt;
        self.times = (0..count).map(|frame| times.get(frame as usize).copied().unwrap_or(alike(frame))).collect();
        self.count = count;
        self.picture = count.checked_sub(1).map(|frame| self.picture(frame));
        Ok(())
    }

    /// How many frames there are.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// Simulated seconds at each frame.
    pub(super) fn times(&self) -> &[f64] {
        &self.times
    }

    fn picture(&self, frame: u64) -> PathBuf {
        self.plan.out.join(format!("frame_{frame:04}.png"))
    }

    fn file(&self, kind: &str, frame: u64, ending: &str) -> PathBuf {
        self.plan.out.join(format!("{kind}_{frame:04}.{ending}"))
    }

    /// Writes the files of a frame, which are on the disk then.
    ///
    /// # Errors
    /// If one cannot be written.
    pub(super) fn write(&mut self, frame: u64, simulation: &dyn Simulation) -> Result<LastFrame<'_>, LabError> {
        let picture = self.picture(frame);
        output::write(&picture, &self.camera.png(simulation)?)?;
        self.exports.clear();
        for export in &self.plan.outputs.export {
            for (file, bytes) in self.exported(*export, frame, simulation)? {
                output::write(&file, &bytes)?;
                self.exports.push(file);
            }
        }
        self.count = frame + 1;
        self.times.truncate(frame as usize);
        self.times.push(simulation.time());
        let picture = self.picture.insert(picture);
        Ok(LastFrame { picture, exports: &self.exports })
    }

    /// The error that ended a run, and up to where its frames are good.
    pub(super) fn with_last(&self, error: LabError) -> LabError {
        match &self.picture {
            Some(picture) => error.and(&format!("; last good frame: {}", picture.display())),
            None => error,
        }
    }

    /// The files of one kind of a frame, with their bytes.
    fn exported(
        &self,
        export: Export,
        frame: u64,
        simulation: &dyn Simulation,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, LabError> {
        Ok(match export {
            Export::Ply => vec![(self.file("particles", frame, "ply"), ply::particles(simulation))],
            Export::Npz => {
                vec![(self.file("particles", frame, "npz"), npz::write(&simulation.particle_arrays(), &[])?)]
            }
            Export::Vtk => {
                let particles = (self.file("particles", frame, "vtp"), vtk::particles(simulation));
                let grid = self.grid.then(|| (self.file("grid", frame, "vti"), vtk::grid(simulation)));
                [particles].into_iter().chain(grid).collect()
            }
        })
    }

    /// Makes what is made of all frames so far, of an earlier part of the run too, and gives the files.
    ///
    /// # Errors
    /// If a picture cannot be read, or a file not be written.
    pub(super) fn finish(&self, reporter: &Reporter) -> Result<Vec<PathBuf>, LabError> {
        let Outputs { gif, mp4, sheet, ref export, .. } = self.plan.outputs;
        let mut files = Vec::new();
        if self.count == 0 {
            return Ok(files);
        }
        if sheet.unwrap_or(self.count > 1) {
            files.push(self.sheet()?);
        }
        if gif {
            files.push(self.gif()?);
        }
        if mp4 && mp4::available() {
            let file = self.plan.out.join("animation.mp4");
            mp4::write(&self.plan.out, self.count, PACE, &file)?;
            files.push(file);
        } else if mp4 {
            reporter
                .note("`ffmpeg` is not installed, and so there is no `animation.mp4`; `--gif` needs no other program");
        }
        if export.contains(&Export::Vtk) {
            files.push(self.series("particles", "vtp")?);
            if self.grid {
                files.push(self.series("grid", "vti")?);
            }
        }
        Ok(files)
    }

    fn time(&self, frame: u64) -> f64 {
        self.times[frame as usize]
    }

    fn sheet(&self) -> Result<PathBuf, LabError> {
        let mut sheet = Sheet::new(self.count as usize);
        for frame in (0..self.count).filter(|&frame| sheet.wants(frame as usize)).collect::<Vec<_>>() {
            let label = sheet::label(self.plan.calendar.step(frame), self.time(frame));
            sheet.add(frame as usize, &read(&self.picture(frame))?, &label);
        }
        let file = self.plan.out.join("sheet.png");
        output::write(&file, &sheet.png()?)?;
        Ok(file)
    }

    fn gif(&self) -> Result<PathBuf, LabError> {
        let first = read(&self.picture(0))?;
        let mut gif = Gif::new(Vec::new(), first.width, first.height, PACE)?;
        gif.add(&first)?;
        for frame in 1..self.count {
            gif.add(&read(&self.picture(frame))?)?;
        }
        let file = self.plan.out.join("animation.gif");
        output::write(&file, &gif.finish()?)?;
        Ok(file)
    }

    /// The list of all files of a kind, for ParaView.
    fn series(&self, kind: &str, ending: &str) -> Result<PathBuf, LabError> {
        let entries: Vec<_> =
            (0..self.count).map(|frame| (self.time(frame), format!("{kind}_{frame:04}.{ending}"))).collect();
        let file = self.plan.out.join(format!("{kind}.pvd"));
        output::write(&file, vtk::pvd(&entries).as_bytes())?;
        Ok(file)
    }
}

/// A picture that was written.
fn read(path: &Path) -> Result<Picture, LabError> {
    let fault = |why: String| LabError::machine(format!("picture `{}` cannot be read again: {why}", path.display()));
    let bytes = std::fs::read(path).map_err(|error| fault(error.to_string()))?;
    Picture::of_png(&bytes).map_err(fault)
}
