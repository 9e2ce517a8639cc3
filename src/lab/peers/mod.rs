//! `allotrope compare`: the workloads here and in another system, in turn, so that a change of the machine's speed meets
//! both alike.

mod bandwidth;
mod ours;
mod report;
mod taichi;

use std::path::{Path, PathBuf};
use std::time::Instant;

use allotrope::Schedule;
use indicatif::{ProgressBar, ProgressStyle};

use self::bandwidth::Loop;
pub use self::ours::{WORKLOADS, Workload};
use self::ours::{Work, repeat};
pub use self::report::{Report, Row};
use self::taichi::{Taichi, Variant};
use super::errors::{LabError, tell};
use super::statistics::median;
use super::{machine, output};

/// A repetition makes as many calls as take so many milliseconds.
const REPETITION: f64 = 60.0;

/// How far results may lie apart, as a fraction: inputs are drawn at random on both sides of the fluid, and Taichi
/// contracts and reorders sums.
const TOLERANCE: f64 = 0.01;

/// What is to be compared.
#[derive(Debug)]
pub struct Plan {
    /// Some of [`WORKLOADS`].
    pub workloads: Vec<&'static Workload>,
    /// The interpreter that has Taichi.
    pub python: PathBuf,
    /// Threads, if so many are asked for.
    pub threads: Option<usize>,
    /// Repetitions of each side.
    pub pairs: usize,
}

/// Runs the plan, prints a table, and writes the report where one is wanted. Where Taichi is missing, the standard error
/// tells how to install it, and our times are measured alone.
///
/// # Errors
/// If a workload fails, both sides come to different results, Taichi ends early, or the report cannot be written.
pub fn compare_taichi(plan: &Plan, json: Option<&Path>) -> Result<(), LabError> {
    if let Some(path) = json {
        output::writable(path)?;
    }
    let threads = machine::threads(plan.threads);
    let mut taichi = match Taichi::start(&plan.python, threads) {
        Ok(taichi) => Some(taichi),
        Err(why) => {
            tell(&format!("{why}\n{}", taichi::HOW_TO_INSTALL));
            None
        }
    };
    let bar = ProgressBar::new(plan.workloads.len() as u64);
    let style = ProgressStyle::with_template("{bar:40} {msg} ({pos}/{len}, {eta} left)");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let mut rows = Vec::new();
    for workload in &plan.workloads {
        bar.set_message(workload.name);
        rows.push(measure(workload, taichi.as_mut(), plan, threads)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let report = Report { threads, isa: machine::instruction_set(), pairs: plan.pairs, rows };
    output::results(&report.text(taichi.as_ref().map(Taichi::version)), &report, json)
}

/// A side of a comparison.
enum Side {
    Ours(Box<dyn Work>),
    Taichi(Variant),
    Memory(Loop),
}

impl Side {
    /// Milliseconds of a call, the mean of so many.
    fn time(
        &mut self,
        name: &str,
        calls: usize,
        schedule: &Schedule,
        taichi: Option<&mut Taichi>,
    ) -> Result<f64, LabError> {
        let start = Instant::now();
        match (self, taichi) {
            (Self::Taichi(variant), Some(taichi)) => return taichi.time(name, *variant, calls),
            (Self::Taichi(_), None) => unreachable!("there is no such side without Taichi"),
            (Self::Ours(work), _) => repeat(schedule, &mut **work, calls)?,
            (Self::Memory(stream), _) => (0..calls).for_each(|_| stream.run()),
        }
        Ok(start.elapsed().as_secs_f64() * 1e3 / calls as f64)
    }
}

/// Repetitions of all sides of a workload in turn, after their results were found to agree.
fn measure(workload: &Workload, mut taichi: Option<&mut Taichi>, plan: &Plan, threads: usize) -> Result<Row, LabError> {
    let (schedule, name) = (machine::SCHEDULES[0].with_threads(Some(threads)), workload.name);
    let mut work = (workload.build)()?;
    let bytes = work.bytes();
    repeat(&schedule, &mut *work, 1)?;
    let result = work.result();
    let mut sides = vec![Side::Ours(work)];
    if let Some(taichi) = taichi.as_deref_mut() {
        let theirs = taichi.build(name)?;
        for (variant, theirs) in [Variant::Written, Variant::Tuned].into_iter().zip(theirs) {
            if !agree(result, theirs) {
                return Err(LabError::failure(format!(
                    "workload `{name}` comes to {result} here and to {theirs} in Taichi ({variant})"
                )));
            }
            sides.push(Side::Taichi(variant));
        }
    }
    // How long a loop of memory would take for the workload's bytes, over how long it takes for its own.
    let mut share = f64::NAN;
    if let Some(stream) = workload.stream {
        let stream = Loop::new(stream, bytes, threads);
        share = bytes as f64 / stream.bytes() as f64;
        sides.push(Side::Memory(stream));
    }

    let mut calls = Vec::new();
    for side in &mut sides {
        let round = if matches!(side, Side::Ours(_)) { workload.round } else { 1 };
        side.time(name, round, &schedule, taichi.as_deref_mut())?;
        let once = side.time(name, round, &schedule, taichi.as_deref_mut())?.max(1e-6);
        let whole = (REPETITION / (once * round as f64)).ceil().clamp(1.0, 1e6) as usize;
        calls.push(whole * round);
    }
    let count = sides.len();
    let mut samples = vec![Vec::new(); count];
    for pair in 0..plan.pairs {
        // Each begins a round in turn, so that none always follows the same one.
        for n in (0..count).map(|n| (pair + n) % count) {
            samples[n].push(sides[n].time(name, calls[n], &schedule, taichi.as_deref_mut())?);
        }
    }
    let ours = &samples[0];
    let ratio = |others: &Vec<f64>| {
        let ratios: Vec<f64> = others.iter().zip(ours).map(|(other, ours)| other / ours).collect();
        median(&ratios)
    };
    let of = |variant| {
        let at = sides.iter().position(|side| matches!(side, Side::Taichi(there) if *there == variant));
        at.map(|at| &samples[at])
    };
    let (written, tuned) = (of(Variant::Written), of(Variant::Tuned));
    let moved = workload.stream.and(samples.last());
    Ok(Row::new(
        name,
        median(ours),
        written.map(|samples| (median(samples), ratio(samples))),
        tuned.map(|samples| (median(samples), ratio(samples))),
        moved.map(|samples| (bytes as f64 / median(ours) / 1e6, share * ratio(samples))),
    ))
}

/// Whether two results are the same, as far as can be asked.
fn agree(ours: f64, theirs: f64) -> bool {
    (theirs - ours).abs() <= TOLERANCE * ours.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_agrees_with_nothing() {
        assert!(agree(-2.0, -2.01) && !agree(-2.0, -2.1) && !agree(-2.0, 2.0));
        assert!(!agree(1.0, f64::NAN) && !agree(f64::NAN, f64::NAN) && !agree(f64::INFINITY, f64::INFINITY));
    }
}
