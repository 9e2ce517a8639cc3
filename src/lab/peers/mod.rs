//! `allotrope compare`: the workloads here and in another system, in turn, so that a change of the machine's speed meets
//! both alike.

mod bandwidth;
mod ours;
mod report;
mod taichi;

use std::path::{Path, PathBuf};
use std::time::Instant;

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
    output::print(&report.text(taichi.as_ref().map(Taichi::version)))?;
    match json {
        Some(path) => {
            let line = serde_json::to_string(&report).map_err(|error| LabError::failure(error.to_string()))?;
            output::write(path, format!("{line}\n").as_bytes())
        }
        None => Ok(()),
    }
}

/// A side of a comparison: what makes so many calls and tells the milliseconds of one.
type Timed<'a> = Box<dyn FnMut(&mut Sides<'_>, usize) -> Result<f64, LabError> + 'a>;

/// What the sides of a comparison work with.
struct Sides<'a> {
    work: &'a mut dyn Work,
    taichi: Option<&'a mut Taichi>,
}

/// Repetitions of all sides of a workload in turn, after their results were found to agree.
fn measure(workload: &Workload, taichi: Option<&mut Taichi>, plan: &Plan, threads: usize) -> Result<Row, LabError> {
    let (schedule, name) = (machine::SCHEDULES[0].with_threads(Some(threads)), workload.name);
    let mut work = (workload.build)(&schedule)?;
    let bytes = work.bytes();
    repeat(&schedule, &mut *work, 1)?;
    let result = work.result();
    let mut sides = Sides { work: &mut *work, taichi };
    let mut timed: Vec<Timed> = vec![Box::new(|sides, calls| {
        let start = Instant::now();
        repeat(&schedule, sides.work, calls)?;
        Ok(start.elapsed().as_secs_f64() * 1e3 / calls as f64)
    })];
    let mut variants = Vec::new();
    if let Some(taichi) = &mut sides.taichi {
        let theirs = taichi.build(name)?;
        for (variant, theirs) in [Variant::Written, Variant::Tuned].into_iter().zip(theirs) {
            if (theirs - result).abs() > TOLERANCE * result.abs() {
                return Err(LabError::failure(format!(
                    "workload `{name}` comes to {result} here and to {theirs} in Taichi ({variant})"
                )));
            }
            variants.push(variant);
            timed.push(Box::new(move |sides, calls| match &mut sides.taichi {
                Some(taichi) => taichi.time(name, variant, calls),
                None => Ok(f64::NAN),
            }));
        }
    }
    // How long a loop of memory would take for the workload's bytes, over how long it takes for its own.
    let mut share = f64::NAN;
    if let Some(stream) = workload.stream {
        let mut stream = Loop::new(stream, bytes, threads);
        share = bytes as f64 / stream.bytes() as f64;
        timed.push(Box::new(move |_, calls| {
            let start = Instant::now();
            (0..calls).for_each(|_| stream.run());
            Ok(start.elapsed().as_secs_f64() * 1e3 / calls as f64)
        }));
    }

    let mut calls = Vec::new();
    for (n, side) in timed.iter_mut().enumerate() {
        let round = if n == 0 { workload.round } else { 1 };
        side(&mut sides, round)?;
        let once = side(&mut sides, round)?.max(1e-6);
        let whole = (REPETITION / (once * round as f64)).ceil().clamp(1.0, 1e6) as usize;
        calls.push(whole * round);
    }
    let sides_count = timed.len();
    let mut samples = vec![Vec::new(); sides_count];
    for pair in 0..plan.pairs {
        // Each begins a round in turn, so that none always follows the same one.
        for n in (0..sides_count).map(|n| (pair + n) % sides_count) {
            samples[n].push(timed[n](&mut sides, calls[n])?);
        }
    }
    let ours = &samples[0];
    let ratio = |others: &Vec<f64>| {
        let ratios: Vec<f64> = others.iter().zip(ours).map(|(other, ours)| other / ours).collect();
        median(&ratios)
    };
    let of = |variant| variants.iter().position(|&there| there == variant).map(|at| &samples[1 + at]);
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
