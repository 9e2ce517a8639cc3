//! `allotrope bench`: one scene in many layouts, interleaved, so that a change of the machine's speed meets all of them
//! alike.

mod report;
mod text;

use std::path::Path;
use std::time::{Duration, Instant};

use allotrope::Schedule;
use allotrope_solvers::{Scene, Simulation, SolverInfo};
use indicatif::{ProgressBar, ProgressStyle};

use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::output;
use super::statistics::{median, spread};
use super::table::six_digits;
pub use report::{Kernels, Report, Row};
use text::{About, text};

/// Repetitions, if there are steps enough.
const REPETITIONS: u64 = 11;

/// What is to be compared.
#[derive(Debug)]
pub struct Plan {
    /// The solver.
    pub solver: &'static SolverInfo,
    /// The scene's name in the results.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// Some of the solver's layouts.
    pub layouts: Vec<&'static str>,
    /// Ways of accumulating; each layout is run with each.
    pub schedules: Vec<NamedSchedule>,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// Timed steps of each row, if so many are asked for.
    pub steps: Option<u64>,
}

/// A layout with a schedule, while it runs.
struct Contender {
    layout: &'static str,
    named: NamedSchedule,
    schedule: Schedule,
    simulation: Box<dyn Simulation>,
    /// Milliseconds a step of each repetition, without sorting.
    samples: Vec<f64>,
    /// The same in each kernel.
    kernels: Vec<Vec<f64>>,
    /// Steps that were taken, also before the first repetition.
    taken: u64,
    /// The time that sorting took in them: sorts are rare, so that it is spread over all.
    sorting: Duration,
}

/// The part of a step that most steps do not have.
const SORT: &str = "sort";

impl Contender {
    /// Takes some steps; gives their time, and that in each kernel, without sorting.
    fn advance(&mut self, steps: u64) -> Result<(Duration, Vec<Duration>), LabError> {
        let Self { simulation, schedule, layout, named, taken, sorting, .. } = self;
        let mut spent = vec![Duration::ZERO; simulation.kernel_names().len()];
        let start = Instant::now();
        let done = schedule.run(|| (0..steps).try_for_each(|_| simulation.step_timed(&mut spent)));
        done.map_err(|error| LabError::failure(format!("{layout} with schedule {}: {error}", named.name)))?;
        let elapsed = start.elapsed();
        let sort = simulation.kernel_names().iter().position(|&name| name == SORT);
        let sorted = sort.map_or(Duration::ZERO, |sort| std::mem::take(&mut spent[sort]));
        *taken += steps;
        *sorting += sorted;
        Ok((elapsed.saturating_sub(sorted), spent))
    }

    /// Milliseconds of sorting a step.
    fn sorting(&self) -> f64 {
        self.sorting.as_secs_f64() * 1e3 / self.taken.max(1) as f64
    }

    /// Takes some steps as one repetition.
    fn repeat(&mut self, steps: u64) -> Result<(), LabError> {
        let (time, spent) = self.advance(steps)?;
        let each = |time: Duration| time.as_secs_f64() * 1e3 / steps as f64;
        self.samples.push(each(time));
        for (samples, time) in self.kernels.iter_mut().zip(spent) {
            samples.push(each(time));
        }
        Ok(())
    }
}

/// Runs the plan, prints a table, and writes the report where one is wanted.
///
/// # Errors
/// If the scene cannot be built, a step is refused, layouts end in different states, or the report cannot be written.
pub fn bench(plan: &Plan, json: Option<&Path>) -> Result<(), LabError> {
    if let Some(path) = json {
        output::writable(path)?;
    }
    let (report, about) = measure(plan)?;
    output::print(&text(&report, &about))?;
    match json {
        Some(path) => {
            let line = serde_json::to_string(&report).map_err(|error| LabError::failure(error.to_string()))?;
            output::write(path, format!("{line}\n").as_bytes())
        }
        None => Ok(()),
    }
}

fn measure(plan: &Plan) -> Result<(Report, About), LabError> {
    let mut contenders = Vec::new();
    for &layout in &plan.layouts {
        for &named in &plan.schedules {
            let simulation = (plan.solver.build)(&plan.scene, layout)?;
            let kernels = vec![Vec::new(); simulation.kernel_names().len()];
            let schedule = named.with_threads(plan.threads);
            contenders.push(Contender {
                layout,
                named,
                schedule,
                simulation,
                samples: Vec::new(),
                kernels,
                taken: 0,
                sorting: Duration::ZERO,
            });
        }
    }

    let bar = ProgressBar::new_spinner();
    bar.set_message("comparing the states of all layouts");
    let verified = verification_steps(contenders[0].simulation.particles(), plan.steps);
    let mut warm = Duration::ZERO;
    for contender in &mut contenders {
        warm += contender.advance(verified)?.0;
        bar.tick();
    }
    let agreement = verify(&contenders, verified)?;

    let pieces = pieces(warm.as_secs_f64() / verified as f64, plan.steps);
    let (repetitions, steps) = (pieces.len() as u64, pieces.iter().sum());
    let style = ProgressStyle::with_template("{bar:40} repetition {pos}/{len}, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_length(repetitions);
    for (repetition, &piece) in pieces.iter().enumerate() {
        // Each begins a round in turn, so that none always follows the same one.
        let first = repetition % contenders.len();
        for n in 0..contenders.len() {
            let next = (first + n) % contenders.len();
            contenders[next].repeat(piece)?;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();

    let reference = contenders[0].simulation.positions();
    let simulation = &contenders[0].simulation;
    let report = Report {
        solver: plan.solver.name.to_string(),
        scene: plan.name.clone(),
        particles: simulation.particles(),
        grid: simulation.grid_shape(),
        threads: machine::threads(plan.threads),
        isa: machine::instruction_set(),
        rows: contenders.iter().map(|contender| row(contender, &reference)).collect(),
    };
    Ok((report, About { verified, agreement, repetitions, steps, time: simulation.time() }))
}

fn row(contender: &Contender, reference: &[[f64; 3]]) -> Row {
    let Contender { layout, named, simulation, samples, kernels, .. } = contender;
    let names = simulation.kernel_names().iter().map(|name| name.to_string());
    let times = kernels
        .iter()
        .zip(simulation.kernel_names())
        .map(|(samples, &name)| six_digits(if name == SORT { contender.sorting() } else { median(samples) }));
    Row {
        layout: layout.to_string(),
        schedule: named.name.to_string(),
        ms_per_step: six_digits(median(samples) + contender.sorting()),
        spread: six_digits(spread(samples)),
        kernels: Kernels(names.zip(times).collect()),
        bytes: simulation.bytes(),
        state_error: six_digits(difference(reference, &simulation.positions()).0),
    }
}

/// The steps of each repetition, where a step of all contenders takes `each` seconds: as many as are asked for, or what
/// takes about 20 seconds.
fn pieces(each: f64, asked: Option<u64>) -> Vec<u64> {
    let steps = asked.unwrap_or_else(|| ((20.0 / each) as u64).clamp(REPETITIONS, 1100));
    let repetitions = REPETITIONS.min(steps);
    (0..repetitions).map(|n| steps * (n + 1) / repetitions - steps * n / repetitions).collect()
}

/// Steps after which the states are compared: 100, fewer where a step is long, and no more than are asked for.
fn verification_steps(particles: usize, asked: Option<u64>) -> u64 {
    let bearable = (4_000_000 / particles.max(1)).clamp(10, 100) as u64;
    bearable.min(asked.unwrap_or(bearable))
}

/// Checks that all contenders are in the state of the first: the order of additions alone may differ, which leaves
/// positions within some roundings of the domain's extent. Gives the largest difference.
fn verify(contenders: &[Contender], steps: u64) -> Result<f64, LabError> {
    let reference = contenders[0].simulation.positions();
    let extent = contenders[0].simulation.extent().into_iter().fold(0.0, f64::max);
    let bound = 1e-5 * extent;
    let mut largest = 0.0f64;
    for contender in &contenders[1..] {
        let (error, particle) = difference(&reference, &contender.simulation.positions());
        if error.is_nan() || error > bound {
            return Err(LabError::failure(format!(
                "after {steps} steps {} with schedule {} is in another state than {}: particle {particle} differs by \
                 {error:.3e}, above {bound:.3e}",
                contender.layout, contender.named.name, contenders[0].layout
            )));
        }
        largest = largest.max(error);
    }
    Ok(largest)
}

/// The largest difference along an axis, and the particle that has it. What is not a number differs most.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> (f64, usize) {
    let mut largest = (0.0, 0);
    for (particle, (a, b)) in a.iter().zip(b).enumerate() {
        for (a, b) in a.iter().zip(b) {
            let error = (a - b).abs();
            if error.is_nan() || error > largest.0 {
                largest = (error, particle);
            }
            if error.is_nan() {
                return largest;
            }
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_find_the_farthest_particle_and_what_is_not_a_number() {
        let a = [[0.0; 3], [1.0, 2.0, 3.0]];
        assert_eq!(difference(&a, &[[0.0; 3], [1.0, 2.5, 3.0]]), (0.5, 1));
        assert_eq!(difference(&a, &a).0, 0.0);
        assert!(difference(&a, &[[f64::NAN, 0.0, 0.0], [9.0; 3]]).0.is_nan());
    }

    #[test]
    fn long_steps_are_verified_over_fewer() {
        assert_eq!(verification_steps(8192, None), 100);
        assert_eq!(verification_steps(1 << 20, None), 10);
        assert_eq!(verification_steps(8192, Some(3)), 3);
    }

    #[test]
    fn repetitions_take_the_steps_asked_for() {
        assert_eq!(pieces(1.0, Some(25)), [2, 2, 2, 3, 2, 2, 2, 3, 2, 2, 3]);
        assert_eq!(pieces(1.0, Some(3)), [1, 1, 1]);
        assert_eq!(pieces(1.0, None), [1, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2]);
        assert_eq!(pieces(10.0, None), [1; 11]);
        assert_eq!(pieces(1e-6, None), [100; 11]);
    }
}
