//! `allotrope convert-cost`: what it costs to go on in another layout, and after how many steps that pays.
//!
//! The state goes over the host: all members are read from the fields of one layout into arrays, and written into the
//! fields of the other, which are there already.

mod report;

use std::path::Path;
use std::time::{Duration, Instant};

use allotrope_solvers::{Scene, SolverInfo};
use indicatif::ProgressBar;

use super::bench::contender::{Contender, difference, verify};
use super::bench::{pieces, verification_steps};
use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::output;
use report::{About, text};
pub use report::{Change, Layout, Report};

/// What is to be changed into what.
#[derive(Debug)]
pub struct Plan {
    /// The solver.
    pub solver: &'static SolverInfo,
    /// The scene's name in the results.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The layout of the solver in which a run is, and the one in which it may go on.
    pub layouts: [&'static str; 2],
    /// How loops accumulate.
    pub schedule: NamedSchedule,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// Timed steps in each layout, if so many are asked for.
    pub steps: Option<u64>,
}

/// Runs the plan, prints what was found, and writes the report where one is wanted.
///
/// # Errors
/// If the scene cannot be built, a step is refused, a state does not go over whole, the layouts end in different states, or
/// the report cannot be written.
pub fn convert_cost(plan: &Plan, json: Option<&Path>) -> Result<(), LabError> {
    if let Some(path) = json {
        output::writable(path)?;
    }
    let (report, about) = measure(plan)?;
    output::results(&text(&report, &about), &report, json)
}

fn measure(plan: &Plan) -> Result<(Report, About), LabError> {
    let make = |layout| Contender::new(plan.solver, &plan.scene, layout, plan.schedule, plan.threads);
    let mut both = plan.layouts.into_iter().map(make).collect::<Result<Vec<_>, _>>()?;
    let bar = ProgressBar::new_spinner();
    bar.set_message("comparing the states of both layouts");

    // The second takes over at its start what the first has come to, and both must go on alike.
    let verified = verification_steps(both[0].simulation.particles(), plan.steps);
    both[0].advance(verified)?;
    hand_over(&mut both)?;
    let mut warm = Duration::ZERO;
    for contender in &mut both {
        warm += contender.advance(verified)?.0;
    }
    let agreement = verify(&both, verified)?;

    let pieces = pieces(warm.as_secs_f64() / (2 * verified) as f64, plan.steps);
    let mut change = [Vec::new(), Vec::new()];
    bar.set_length(pieces.len() as u64);
    for (repetition, &piece) in pieces.iter().enumerate() {
        // Each is the first one in turn, and both begin in the same state.
        let spent = hand_over(&mut both)?;
        for (times, time) in change.iter_mut().zip(spent) {
            times.push(time);
        }
        let first = repetition % 2;
        both[first].repeat(piece, None)?;
        both[1 - first].repeat(piece, None)?;
        bar.inc(1);
    }
    bar.finish_and_clear();

    let simulation = &both[0].simulation;
    let report = Report {
        solver: plan.solver.name.to_string(),
        scene: plan.name.clone(),
        particles: simulation.particles(),
        grid: simulation.grid_shape(),
        threads: machine::threads(plan.threads),
        isa: machine::instruction_set(),
        schedule: plan.schedule.name.to_string(),
        from: Layout::new(&both[0]),
        to: Layout::new(&both[1]),
        change: Change::new(&both[0], &both[1], &change),
    };
    let (repetitions, steps) = (pieces.len() as u64, pieces.iter().sum());
    Ok((report, About { verified, agreement, repetitions, steps, time: simulation.time() }))
}

/// Lets the second go on where the first is; gives the milliseconds of reading and of writing the state.
fn hand_over(both: &mut [Contender]) -> Result<[f64; 2], LabError> {
    let [from, to] = both else { unreachable!("there are two layouts") };
    let start = Instant::now();
    let state = from.simulation.save();
    let read = start.elapsed();
    let fault = |why: String| {
        LabError::failure(format!("the state of {} does not go over to {}: {why}", from.layout, to.layout))
    };
    to.simulation.restore(&state).map_err(fault)?;
    let all = start.elapsed();
    let (error, particle) = difference(&from.simulation.positions(), &to.simulation.positions());
    if error != 0.0 || from.simulation.steps() != to.simulation.steps() {
        return Err(fault(format!("particle {particle} differs by {error:.3e}")));
    }
    Ok([read, all - read].map(|time| time.as_secs_f64() * 1e3))
}
