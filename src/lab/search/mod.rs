//! `allotrope search`: the best layout, schedule and interval of sorting for a scene, by successive halving.
//!
//! All candidates take the same steps of one scene, in interleaved pieces. After each round those that are told to be slower than half of the
//! others are dropped, so that the time goes to those that are near the best (Jamieson & Talwalkar 2016, "Non-stochastic best arm
//! identification"). What cannot be told apart is kept.

mod halving;
mod text;
mod tuned;

use std::path::Path;
use std::time::{Duration, Instant};

use allotrope_solvers::scene::Reorder;
use allotrope_solvers::{Scene, SolverInfo};
use indicatif::{ProgressBar, ProgressStyle};

use super::bench::contender::{Contender, verify};
use super::bench::verification_steps;
use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::output;
use super::statistics::median;
use halving::survivors;
use text::text;
pub use tuned::{Choice, Tuned};

/// The part of a round's time that one piece of all candidates takes, at most.
const PIECES: f64 = 8.0;

/// Pieces a round, at least: fewer tell nothing of how far times differ.
const FEWEST: usize = 6;

/// Where one is to be searched.
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
    /// Ways of accumulating.
    pub schedules: Vec<NamedSchedule>,
    /// When particles are sorted.
    pub reorders: Vec<Reorder>,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// About how long all of it may take.
    pub budget: Duration,
    /// Whether all candidates run to the end, none dropped on the way.
    pub exhaustive: bool,
}

/// One of the candidates, while it runs.
struct Candidate {
    contender: Contender,
    reorder: Reorder,
    /// Milliseconds a step in each piece, without sorting: the pieces of all candidates are the same steps.
    pieces: Vec<f64>,
}

/// What was found.
#[derive(Clone, Debug)]
struct Found {
    layout: &'static str,
    schedule: &'static str,
    reorder: Reorder,
    /// Milliseconds a step in each piece, sorting included.
    pieces: Vec<f64>,
    /// The rounds that it was in.
    rounds: usize,
}

/// How the search went.
struct About {
    verified: u64,
    agreement: f64,
    rounds: usize,
    seconds: f64,
    steps: u64,
    time: f64,
}

/// Searches, prints the ranking, and writes the best where it is wanted.
///
/// # Errors
/// If the scene cannot be built, candidates do not fit in memory, a step is refused, candidates end in different states, or the file cannot be
/// written.
pub fn search(plan: &Plan, out: Option<&Path>) -> Result<(), LabError> {
    if let Some(path) = out {
        output::writable(path)?;
    }
    let start = Instant::now();
    let mut candidates = candidates(plan)?;
    let bar = ProgressBar::new_spinner();
    bar.set_message(format!("comparing the states of {} candidates", candidates.len()));
    let particles = candidates[0].contender.simulation.particles();
    // A first step tells how many can be borne.
    let more = verification_steps(particles, None).min(bearable(plan.budget, &mut candidates)?);
    let (verified, mut warm) = (1 + more, Duration::ZERO);
    for candidate in &mut candidates {
        warm += candidate.contender.advance_with_sorts(more)?;
        bar.tick();
    }
    let agreement = verify(candidates.iter().map(|candidate| &candidate.contender), verified)?;

    let halvings = candidates.len().next_power_of_two().ilog2().max(1) as usize;
    let rounds = if plan.exhaustive { 1 } else { halvings };
    let style = ProgressStyle::with_template("{bar:40} round {pos} of {len}, {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_length(rounds as u64);
    let header = Header::of(plan, &candidates[0].contender);
    let mut step = warm.as_secs_f64() / more as f64;
    let (mut steps, mut lost) = (0, Vec::new());
    for round in 1..=rounds {
        bar.set_message(format!("{} candidates", candidates.len()));
        let left = plan.budget.saturating_sub(start.elapsed()).as_secs_f64() / (rounds + 1 - round) as f64;
        steps += run_round(&mut candidates, step, left)?;
        step = candidates.iter().map(|candidate| median(&candidate.times())).sum::<f64>() * 1e-3;
        if round < rounds {
            let kept = survivors(&candidates.iter().map(Candidate::times).collect::<Vec<_>>());
            let (stay, leave): (Vec<_>, Vec<_>) =
                candidates.into_iter().enumerate().partition(|(n, _)| kept.contains(n));
            lost.extend(leave.into_iter().map(|(_, candidate)| candidate.found(round)));
            candidates = stay.into_iter().map(|(_, candidate)| candidate).collect();
        }
        bar.inc(1);
    }
    bar.finish_and_clear();

    let time = candidates[0].contender.simulation.time();
    let mut found: Vec<_> = candidates.into_iter().map(|candidate| candidate.found(rounds)).collect();
    found.extend(lost);
    // Those that went farther come first.
    found.sort_by(|a, b| b.rounds.cmp(&a.rounds).then(median(&a.pieces).total_cmp(&median(&b.pieces))));
    let seconds = start.elapsed().as_secs_f64();
    let about = About { verified, agreement, rounds, seconds, steps, time };
    let tuned = header.tuned(&found[0]);
    output::print(&text(&header, &found, &about, &tuned))?;
    out.map_or(Ok(()), |path| output::write(path, tuned.line().as_bytes()))
}

/// What all candidates have in common.
struct Header {
    solver: &'static str,
    scene: String,
    particles: usize,
    grid: Vec<usize>,
    threads: usize,
    isa: String,
}

impl Header {
    fn of(plan: &Plan, contender: &Contender) -> Self {
        Self {
            solver: plan.solver.name,
            scene: plan.name.clone(),
            particles: contender.simulation.particles(),
            grid: contender.simulation.grid_shape(),
            threads: machine::threads(plan.threads),
            isa: machine::instruction_set(),
        }
    }

    fn tuned(&self, best: &Found) -> Tuned {
        let Found { layout, schedule, reorder, .. } = best;
        let (layout, schedule, reorder) = (layout.to_string(), schedule.to_string(), reorder.to_string());
        let (scene, particles) = (self.scene.clone(), self.particles);
        let choice =
            Choice { layout, schedule, reorder, scene, particles, threads: self.threads, isa: self.isa.clone() };
        Tuned::of(self.solver, choice)
    }
}

impl Candidate {
    /// Milliseconds a step in each piece, over which the sorts of all steps are spread: they are rare, and in few pieces.
    fn times(&self) -> Vec<f64> {
        let sorting = self.contender.sorting();
        self.pieces.iter().map(|piece| piece + sorting).collect()
    }

    fn found(self, rounds: usize) -> Found {
        let pieces = self.times();
        let Contender { layout, named, .. } = self.contender;
        Found { layout, schedule: named.name, reorder: self.reorder, pieces, rounds }
    }
}

/// All that are to be compared, at the start of the scene.
fn candidates(plan: &Plan) -> Result<Vec<Candidate>, LabError> {
    let count = plan.layouts.len() * plan.schedules.len() * plan.reorders.len();
    let mut candidates: Vec<Candidate> = Vec::with_capacity(count);
    for &reorder in &plan.reorders {
        // What sorts nothing takes its scene as it is.
        let scene =
            if plan.scene.setup.sorts() { plan.scene.clone().with_reorder(reorder)? } else { plan.scene.clone() };
        for &layout in &plan.layouts {
            for &named in &plan.schedules {
                let contender = Contender::new(plan.solver, &scene, layout, named, plan.threads)?;
                if candidates.is_empty() {
                    fits_in_memory(count, contender.simulation.bytes())?;
                }
                candidates.push(Candidate { contender, reorder, pieces: Vec::new() });
            }
        }
    }
    Ok(candidates)
}

/// Refuses more than the machine has memory for, where the system tells how much there is.
fn fits_in_memory(count: usize, bytes: usize) -> Result<(), LabError> {
    let told = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
    let free =
        told.lines().find_map(|line| line.strip_prefix("MemAvailable:")?.split_whitespace().next()?.parse().ok());
    let (mebibytes, Some(free)) = (bytes as f64 / f64::from(1 << 20), free) else { return Ok(()) };
    let kibibytes: f64 = free;
    let free = kibibytes / 1024.0;
    if count as f64 * mebibytes <= 0.8 * free {
        return Ok(());
    }
    Err(LabError::usage(format!(
        "{count} candidates of about {mebibytes:.0} MiB do not fit in the {free:.0} MiB of memory that are free; name fewer by \
         `--layouts`, `--schedules` or `--intervals`"
    )))
}

/// How many steps all candidates can take in a tenth of the budget, as far as a first one tells.
fn bearable(budget: Duration, candidates: &mut [Candidate]) -> Result<u64, LabError> {
    let mut spent = Duration::ZERO;
    for candidate in candidates {
        spent += candidate.contender.advance_with_sorts(1)?;
    }
    let steps = 0.1 * budget.as_secs_f64() / spent.as_secs_f64().max(1e-9);
    Ok((steps as u64).max(1))
}

/// Lets all candidates take the same steps, in pieces, for so many seconds; gives the steps. A step of them all takes about `step` seconds.
fn run_round(candidates: &mut [Candidate], step: f64, seconds: f64) -> Result<u64, LabError> {
    let piece = ((seconds / PIECES / step.max(1e-9)) as u64).max(1);
    let (start, mut taken) = (Instant::now(), 0);
    for n in 0.. {
        if n >= FEWEST && start.elapsed().as_secs_f64() >= seconds {
            break;
        }
        let count = candidates.len();
        // Each begins in turn, so that none always follows the same one.
        for k in 0..count {
            let candidate = &mut candidates[(n + k) % count];
            let (time, _) = candidate.contender.advance(piece)?;
            candidate.pieces.push(1e3 * time.as_secs_f64() / piece as f64);
        }
        taken += piece;
    }
    Ok(taken)
}
