//! `allotrope run`: a scene in one layout, with pictures.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use allotrope_solvers::{Scene, SolverInfo};
use indicatif::{ProgressBar, ProgressStyle};

use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::output;
use super::render::{Camera, Shading};

/// What is to be run.
#[derive(Debug)]
pub struct Plan {
    /// The solver.
    pub solver: &'static SolverInfo,
    /// The scene.
    pub scene: Scene,
    /// One of the solver's layouts.
    pub layout: &'static str,
    /// How the grid is accumulated.
    pub schedule: NamedSchedule,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// Steps to take.
    pub steps: u64,
    /// Steps from one picture to the next.
    pub every: u64,
    /// The folder for the pictures.
    pub out: PathBuf,
}

/// Runs the plan: pictures `frame_0000.png`, .. from the start on, a progress bar where there is a terminal, and a last
/// line with the speed.
///
/// # Errors
/// If the scene cannot be built, a step is refused or a picture cannot be written.
pub fn run(plan: &Plan) -> Result<(), LabError> {
    let mut simulation = (plan.solver.build)(&plan.scene, plan.layout)?;
    output::folder(&plan.out)?;
    let schedule = plan.schedule.with_threads(plan.threads);
    let grid: Vec<String> = simulation.grid_shape().iter().map(usize::to_string).collect();
    output::print(&format!(
        "{} of scene {} in {}: {} particles, {} nodes, {} threads, {}\n",
        plan.solver.name,
        plan.scene.file,
        plan.layout,
        simulation.particles(),
        grid.join(" x "),
        machine::threads(plan.threads),
        machine::instruction_set()
    ))?;

    let camera = Camera::new(&*simulation, &plan.scene, Shading::fitting(&*simulation));
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} steps, {per_sec}, {eta} left {msg}");
    let bar = ProgressBar::new(plan.steps).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let picture = |number: u64, simulation: &dyn allotrope_solvers::Simulation| {
        let path = plan.out.join(format!("frame_{number:04}.png"));
        output::write(&path, &camera.png(simulation)?)
    };
    picture(0, &*simulation)?;
    let (mut done, mut frames, mut spent) = (0, 1, Duration::ZERO);
    while done < plan.steps {
        let piece = plan.every.min(plan.steps - done);
        let start = Instant::now();
        schedule.run(|| {
            let mut shown = Instant::now();
            for step in 0..piece {
                simulation.step()?;
                if shown.elapsed() > Duration::from_millis(100) {
                    bar.set_position(done + step + 1);
                    shown = Instant::now();
                }
            }
            Ok::<(), LabError>(())
        })?;
        spent += start.elapsed();
        done += piece;
        bar.set_position(done);
        picture(frames, &*simulation)?;
        frames += 1;
    }
    bar.finish_and_clear();
    output::print(&format!(
        "{done} steps ({:.3} s simulated) in {:.2} s, {:.0} steps a second without the pictures; {frames} pictures in \
         {}\n",
        simulation.time(),
        spent.as_secs_f64(),
        done as f64 / spent.as_secs_f64(),
        plan.out.display()
    ))
}
