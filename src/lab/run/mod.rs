//! `allotrope run`: a scene in one layout, with pictures and files of particles.

mod calendar;
pub mod check;
mod frames;
mod progress;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use allotrope::Schedule;
use allotrope_solvers::{Scene, Simulation, SolverInfo};

use super::checkpoint::{self, Checkpoint, Header, Planned};
use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::output;
use super::render::Shading;
use super::scene::size;
use super::shell::quoted;
use super::signals::Signals;
pub use calendar::Calendar;
pub use frames::{Export, Outputs};
use frames::{Frames, LastFrame};
pub use progress::Progress;
use progress::{Event, Reason, Reporter};

/// What is to be run.
#[derive(Debug)]
pub struct Plan {
    /// The solver.
    pub solver: &'static SolverInfo,
    /// The scene.
    pub scene: Scene,
    /// The folder of the files that the scene names; none for the files of the built-in scenes.
    pub scene_folder: Option<PathBuf>,
    /// One of the solver's layouts.
    pub layout: &'static str,
    /// How loops accumulate.
    pub schedule: NamedSchedule,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// Whether results are to be the same bits for any number of threads.
    pub deterministic: bool,
    /// When frames and checkpoints are made.
    pub calendar: Calendar,
    /// What is made of frames.
    pub outputs: Outputs,
    /// The folder for all files.
    pub out: PathBuf,
}

impl Plan {
    /// The schedule of all steps.
    fn schedule(&self) -> Schedule {
        Schedule { deterministic: self.deterministic, ..self.schedule.with_threads(self.threads) }
    }

    /// What a checkpoint after `done` steps says, with the times of the frames up to then.
    fn header(&self, done: u64, frame_times: Vec<f64>) -> Header {
        let Self { calendar, outputs, .. } = self;
        Header {
            format: checkpoint::FORMAT,
            version: env!("CARGO_PKG_VERSION").to_string(),
            solver: self.solver.name.to_string(),
            scene: self.scene.file.clone(),
            folder: self.scene_folder.clone(),
            layout: self.layout.to_string(),
            isa: machine::instruction_set(),
            steps_done: done,
            frames_done: calendar.frames(done),
            frame_times,
            plan: Planned {
                reorder: self.scene.reorder().to_string(),
                steps: calendar.steps,
                every: calendar.every,
                checkpoint_every: calendar.checkpoint_every,
                shading: outputs.shading.map(|shading| shading.name().to_string()),
                schedule: self.schedule.name.to_string(),
                threads: self.threads,
                deterministic: self.deterministic,
                export: outputs.export.clone(),
                gif: outputs.gif,
                mp4: outputs.mp4,
                sheet: outputs.sheet,
            },
        }
    }
}

/// Runs the plan, from the start or from a checkpoint on: pictures `frame_0000.png`, .. and what else was asked for,
/// while it is told how far the run is.
///
/// # Errors
/// If the scene cannot be built, the checkpoint is not of it, a step is refused, a file cannot be written or a signal
/// ended the run.
pub fn run(plan: &Plan, resumed: Option<&Checkpoint>, progress: Progress, quiet: bool) -> Result<(), LabError> {
    let signals = Signals::listen()?;
    let mut simulation = (plan.solver.build)(&plan.scene, plan.layout)?;
    if plan.outputs.shading == Some(Shading::Pressure) && simulation.pressures().is_empty() {
        let message = format!("`--shading pressure` cannot be: particles of `{}` have no pressure", plan.solver.name);
        return Err(LabError::usage(message));
    }
    // The camera and the scale of colours are those of the start.
    let mut frames = Frames::new(&*simulation, plan);
    if let Some(checkpoint) = resumed {
        checkpoint.restore(&mut *simulation)?;
        frames.already(plan.calendar.frames(simulation.steps()), &checkpoint.header.frame_times)?;
    }
    output::folder(&plan.out)?;
    let reporter = Reporter::new(progress, quiet, plan.calendar.steps, simulation.steps());
    if let Some(checkpoint) = resumed {
        let (there, here) = (&checkpoint.header.isa, machine::instruction_set());
        if *there != here {
            reporter.note(&format!(
                "the checkpoint was written with {there}, and this is {here}: results agree but for rounding"
            ));
        }
    }
    reporter.tell(&start(plan, &*simulation))?;

    let (began, first, time) = (Instant::now(), simulation.steps(), simulation.time());
    let mut run = Run { plan, signals, frames, reporter, spent: Duration::ZERO, first, done: first, time };
    let outcome = run.advance(&mut *simulation);
    let (reason, error) = match outcome {
        Ok(None) => (Reason::Finished, None),
        Ok(Some(signal)) => (Reason::Interrupted, Some(run.interrupted(&*simulation, signal)?)),
        // Nothing more is written where something cannot be.
        Err(error) if error.status() == super::errors::MACHINE => return Err(run.frames.with_last(error)),
        Err(error) => (Reason::Failed, Some(run.frames.with_last(error))),
    };
    let done = run.done;
    let files = run.frames.finish(&run.reporter)?;
    let text = run.last_line(done, &files) + &bounds(&*simulation);
    let frames = run.frames.count();
    let seconds = began.elapsed().as_secs_f64();
    let time = run.time;
    run.reporter.tell(&Event::End { reason, step: done, time, seconds, frames, files: &files, text })?;
    error.map_or(Ok(()), Err)
}

/// A run while it goes on.
struct Run<'a> {
    plan: &'a Plan,
    signals: Signals,
    frames: Frames<'a>,
    reporter: Reporter,
    /// In steps alone.
    spent: Duration,
    /// Steps that were done before.
    first: u64,
    /// Steps that are done, without one that was refused.
    done: u64,
    /// Simulated seconds after them.
    time: f64,
}

impl Run<'_> {
    /// Steps to the end, or until a signal comes, which is given.
    fn advance(&mut self, simulation: &mut dyn Simulation) -> Result<Option<u8>, LabError> {
        let calendar = self.plan.calendar;
        if simulation.steps() == 0 {
            self.frame(simulation)?;
        }
        while simulation.steps() < calendar.steps {
            let next = calendar.next(simulation.steps());
            let start = Instant::now();
            self.plan.schedule().run(|| {
                while simulation.steps() < next && self.signals.asked().is_none() {
                    simulation.step()?;
                    (self.done, self.time) = (simulation.steps(), simulation.time());
                    self.reporter.step(self.done);
                }
                Ok::<(), LabError>(())
            })?;
            self.spent += start.elapsed();
            if simulation.steps() == next {
                self.frame(simulation)?;
                if calendar.checkpoint(next) {
                    self.checkpoint(simulation)?;
                }
            }
            if let Some(signal) = self.signals.asked() {
                return Ok(Some(signal));
            }
        }
        Ok(None)
    }

    /// Makes the frame of the present step, if there is one.
    fn frame(&mut self, simulation: &dyn Simulation) -> Result<(), LabError> {
        let step = simulation.steps();
        let Some(number) = self.plan.calendar.frame(step) else { return Ok(()) };
        let LastFrame { picture, exports } = self.frames.write(number, simulation)?;
        let (time, steps) = (simulation.time(), self.plan.calendar.steps);
        self.reporter.tell(&Event::Frame { number, step, time, file: picture, exports, steps })
    }

    fn checkpoint(&mut self, simulation: &dyn Simulation) -> Result<PathBuf, LabError> {
        let file = self.plan.out.join(checkpoint::FILE);
        let step = simulation.steps();
        checkpoint::save(
            &file,
            &self.plan.header(step, self.frames.times().to_vec()),
            &self.plan.scene.text,
            &simulation.save(),
        )?;
        self.reporter.tell(&Event::Checkpoint { step, time: simulation.time(), file: &file })?;
        Ok(file)
    }

    /// Writes a checkpoint, and tells how to go on.
    fn interrupted(&mut self, simulation: &dyn Simulation, signal: u8) -> Result<LabError, LabError> {
        let file = self.checkpoint(simulation)?;
        let message = format!(
            "interrupted after step {} of {}; go on with `allotrope run --resume {}`",
            simulation.steps(),
            self.plan.calendar.steps,
            quoted(&file.display().to_string())
        );
        Ok(LabError::interrupted(message, signal))
    }

    fn last_line(&self, done: u64, files: &[PathBuf]) -> String {
        let steps = done - self.first;
        let mut line = format!("{steps} steps (to {:.3} s simulated)", self.time);
        if steps > 0 {
            let seconds = self.spent.as_secs_f64();
            line += &format!(
                " in {seconds:.2} s, {:.0} steps a second without the pictures",
                steps as f64 / seconds.max(1e-9)
            );
        }
        match self.frames.count() {
            0 => (),
            1 => line += &format!("; 1 picture in {}", self.plan.out.display()),
            count => line += &format!("; {count} pictures in {}", self.plan.out.display()),
        }
        let names: Vec<_> = files.iter().filter_map(|file| Some(file.file_name()?.to_string_lossy())).collect();
        if !names.is_empty() {
            line += &format!(" with {}", names.join(", "));
        }
        line + "\n"
    }
}

/// The length of the last step, and what it must not be longer than; nothing where steps do not follow from such bounds.
fn bounds(simulation: &dyn Simulation) -> String {
    let bounds = simulation.step_bounds();
    if bounds.is_empty() || simulation.steps() == 0 {
        return String::new();
    }
    // What is at rest bounds nothing.
    let bounds: Vec<_> = bounds
        .iter()
        .filter(|(_, most)| most.is_finite())
        .map(|(what, most)| format!("{most:.2e} for {what}"))
        .collect();
    format!("the last step took {:.2e} s, of at most {}\n", simulation.dt(), bounds.join(", "))
}

fn start<'a>(plan: &'a Plan, simulation: &dyn Simulation) -> Event<'a> {
    let Plan { solver, scene, layout, calendar, deterministic, .. } = plan;
    let (particles, grid) = (simulation.particles(), simulation.grid_shape());
    let (threads, isa) = (machine::threads(plan.threads), machine::instruction_set());
    let (seeds, step) = (seeds(scene), simulation.steps());
    let numbers: Vec<String> = seeds.iter().map(u64::to_string).collect();
    let mut text = format!(
        "{} of scene {} in {layout}: {}, {threads} threads, {isa}, seed {}",
        solver.name,
        scene.file,
        size(particles, "", &grid),
        numbers.join(", ")
    );
    if *deterministic {
        text += ", deterministic";
    }
    if step > 0 {
        text += &format!("; resumed after step {step} of {}", calendar.steps);
    }
    text.push('\n');
    Event::Start {
        version: env!("CARGO_PKG_VERSION"),
        solver: solver.name,
        scene: &scene.file,
        layout,
        particles,
        grid,
        threads,
        isa,
        deterministic: *deterministic,
        seeds,
        step,
        steps: calendar.steps,
        text,
    }
}

/// The seeds of all that is placed at random, each once; that of the scene if nothing is.
fn seeds(scene: &Scene) -> Vec<u64> {
    let mut seeds = Vec::new();
    for seed in scene.setup.seeds() {
        if !seeds.contains(&seed) {
            seeds.push(seed);
        }
    }
    if seeds.is_empty() { vec![scene.seed] } else { seeds }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_are_those_of_what_is_random() {
        let solver = allotrope_solvers::solver("mpm").unwrap();
        assert_eq!(seeds(&solver.scene("mpm88").unwrap()), [88]);
        assert_eq!(seeds(&solver.scene("bunny").unwrap()), [0]);
    }
}
