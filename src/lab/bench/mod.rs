//! `allotrope bench`: one scene in many layouts, interleaved, so that a change of the machine's speed meets all of them
//! alike.

pub(super) mod contender;
mod report;
pub(super) mod text;

use std::path::Path;
use std::time::Duration;

use allotrope_solvers::{Scene, SolverInfo};
use indicatif::{ProgressBar, ProgressStyle};

use super::errors::LabError;
use super::hardware::Counters;
use super::machine::{self, NamedSchedule};
use super::output;
use super::statistics::{median, spread};
use super::table::six_digits;
use contender::{Contender, SORT, difference, verify};
pub use report::{Named, Report, Row};
use text::{About, text};

/// Repetitions, if there are steps enough.
const REPETITIONS: u64 = 11;

/// About how many seconds all repetitions take, if no steps are asked for.
pub(super) const SECONDS: f64 = 20.0;

/// What is to be compared.
#[derive(Clone, Debug)]
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
    /// Whether processor and system count too, where they can.
    pub hardware: bool,
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
    output::results(&text(&report, &about), &report, json)
}

pub(super) fn measure(plan: &Plan) -> Result<(Report, About), LabError> {
    let compared = compare(plan, SECONDS)?;
    Ok((compared.report(plan), compared.about))
}

/// All contenders of a plan at their ends, and how they came there.
pub(super) struct Compared {
    pub(super) contenders: Vec<Contender>,
    pub(super) about: About,
}

/// Checks that all contenders come to the same state, and times them for about so many seconds, if no steps are asked for.
pub(super) fn compare(plan: &Plan, seconds: f64) -> Result<Compared, LabError> {
    // Before any loop runs on several threads.
    let mut counters = plan.hardware.then(Counters::open);
    let mut contenders = Vec::new();
    for &layout in &plan.layouts {
        for &named in &plan.schedules {
            contenders.push(Contender::new(plan.solver, &plan.scene, layout, named, plan.threads)?);
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

    let pieces = pieces_within(seconds, warm.as_secs_f64() / verified as f64, plan.steps);
    let (repetitions, steps) = (pieces.len() as u64, pieces.iter().sum());
    let style = ProgressStyle::with_template("{bar:40} repetition {pos}/{len}, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_length(repetitions);
    for (repetition, &piece) in pieces.iter().enumerate() {
        // Each begins a round in turn, so that none always follows the same one.
        let first = repetition % contenders.len();
        for n in 0..contenders.len() {
            let next = (first + n) % contenders.len();
            contenders[next].repeat(piece, counters.as_mut())?;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();

    let time = contenders[0].simulation.time();
    let refused = counters.and_then(|counters| counters.refused());
    let about = About { verified, agreement, repetitions, steps, time, left_out: left_out(plan), refused };
    Ok(Compared { contenders, about })
}

impl Compared {
    /// What was found.
    pub(super) fn report(&self, plan: &Plan) -> Report {
        let simulation = &self.contenders[0].simulation;
        let reference = simulation.positions();
        Report {
            solver: plan.solver.name.to_string(),
            scene: plan.name.clone(),
            particles: simulation.particles(),
            grid: simulation.grid_shape(),
            threads: machine::threads(plan.threads),
            isa: machine::instruction_set(),
            rows: self.contenders.iter().map(|contender| row(contender, &reference)).collect(),
        }
    }
}

/// The layouts that do not fit, and why, if all that fit are compared.
fn left_out(plan: &Plan) -> Vec<(&'static str, &'static str)> {
    let names = plan.solver.layouts.iter().map(|layout| layout.name);
    let (fit, unfit): (Vec<_>, Vec<_>) =
        names.map(|layout| (layout, (plan.solver.unfit)(&plan.scene, layout))).partition(|(_, why)| why.is_none());
    if !fit.iter().all(|(layout, _)| plan.layouts.contains(layout)) {
        return Vec::new();
    }
    unfit.into_iter().filter_map(|(layout, why)| Some((layout, why?))).collect()
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
        kernels: Named(names.zip(times).collect()),
        bytes: simulation.bytes(),
        state_error: six_digits(difference(reference, &simulation.positions()).0),
        counted: Named(contender.counted().into_iter().map(|(name, count)| (name, six_digits(count))).collect()),
    }
}

/// The steps of each repetition, where a step of all contenders takes `each` seconds: as many as are asked for, or what
/// takes about [`SECONDS`].
pub(super) fn pieces(each: f64, asked: Option<u64>) -> Vec<u64> {
    pieces_within(SECONDS, each, asked)
}

/// The same for about so many seconds.
fn pieces_within(seconds: f64, each: f64, asked: Option<u64>) -> Vec<u64> {
    let steps = asked.unwrap_or_else(|| ((seconds / each) as u64).clamp(REPETITIONS, 1100));
    let repetitions = REPETITIONS.min(steps);
    (0..repetitions).map(|n| steps * (n + 1) / repetitions - steps * n / repetitions).collect()
}

/// Steps after which the states are compared: 100, fewer where a step is long, and no more than are asked for.
pub(super) fn verification_steps(particles: usize, asked: Option<u64>) -> u64 {
    let bearable = (4_000_000 / particles.max(1)).clamp(10, 100) as u64;
    bearable.min(asked.unwrap_or(bearable))
}

#[cfg(test)]
mod tests {
    use super::*;

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
