//! Interleaved pairs of a kernel and its twin, and what is told of them.
//!
//! `ROUNDS` is how often all is allocated anew (5 unless told), `PAIRS` the pairs a round (13), `THREADS` the threads (1).

use std::cell::RefCell;
use std::time::Instant;

use allotrope::prelude::*;

/// A number from the environment.
pub(crate) fn number(name: &str, usual: usize) -> usize {
    let text = std::env::var(name).ok();
    text.map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}: give a number")))
}

/// Runs rounds of pairs, and prints a line for each.
pub(crate) fn rounds(round: impl Fn(&Pairs) + Sync) {
    let filter = std::env::args().skip(1).find(|arg| !arg.starts_with('-'));
    let (rounds, count, threads) = (number("ROUNDS", 5), number("PAIRS", 13), number("THREADS", 1));
    let schedule = Schedule { threads, ..Schedule::default() };
    let pairs = Pairs { filter, count, cpu: schedule.instruction_set(), threads, lines: RefCell::default() };
    let start = Instant::now();
    schedule.run(|| {
        // Where memory lies decides some per cent of a stream's time: every round allocates anew.
        for _ in 0..rounds {
            round(&pairs);
        }
    });
    println!("| kernel | set | kernel ms | twin ms | ratio | 95 % interval |");
    println!("|---|---|---|---|---|---|");
    for line in pairs.lines.borrow_mut().iter_mut() {
        line.print(pairs.cpu);
    }
    let spent = start.elapsed().as_secs_f64();
    println!("\n{} pairs a line in {rounds} rounds, {threads} threads, {spent:.0} s in all", rounds * count);
}

/// Pairs of one kernel and one twin.
pub(crate) struct Pairs {
    filter: Option<String>,
    /// Pairs a round.
    count: usize,
    pub(crate) cpu: Cpu,
    pub(crate) threads: usize,
    lines: RefCell<Vec<Line>>,
}

/// What was measured of one pair.
struct Line {
    name: String,
    kernel: Vec<f64>,
    twin: Vec<f64>,
}

impl Line {
    fn print(&mut self, cpu: Cpu) {
        let mut ratios: Vec<f64> = self.kernel.iter().zip(&self.twin).map(|(kernel, twin)| kernel / twin).collect();
        let (low, high) = bootstrap(&ratios);
        let (kernel, twin) = (median(&mut self.kernel) * 1e3, median(&mut self.twin) * 1e3);
        let digits = if kernel < 0.01 { 6 } else { 4 };
        println!(
            "| {} | {cpu} | {kernel:.digits$} | {twin:.digits$} | {:.3} | {low:.3} to {high:.3} |",
            self.name,
            median(&mut ratios)
        );
    }
}

/// Runs `work` as often as takes a few milliseconds, and returns the time of one.
pub(crate) fn time(repeat: u32, work: &mut dyn FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..repeat {
        work();
    }
    start.elapsed().as_secs_f64() / f64::from(repeat)
}

pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 { values[middle] } else { 0.5 * (values[middle - 1] + values[middle]) }
}

/// The 95 % interval of the median, from 2000 resamples.
fn bootstrap(values: &[f64]) -> (f64, f64) {
    let mut state = 1u64;
    let mut medians: Vec<f64> = (0..2000)
        .map(|_| {
            let mut sample: Vec<f64> = (0..values.len())
                .map(|_| {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    values[(state >> 33) as usize % values.len()]
                })
                .collect();
            median(&mut sample)
        })
        .collect();
    medians.sort_by(f64::total_cmp);
    (medians[50], medians[1949])
}

impl Pairs {
    /// Whether a line was asked for.
    pub(crate) fn wants(&self, name: &str) -> bool {
        self.filter.as_ref().is_none_or(|filter| name.contains(filter))
    }

    /// Times both in pairs, some milliseconds each time.
    pub(crate) fn run(&self, name: &str, mut kernel: impl FnMut(), mut twin: impl FnMut()) {
        kernel();
        twin();
        let once = time(1, &mut twin);
        let repeat = (0.004 / once).clamp(1.0, 10_000.0) as u32;
        let mut lines = self.lines.borrow_mut();
        if !lines.iter().any(|line| line.name == name) {
            lines.push(Line { name: name.to_owned(), kernel: Vec::new(), twin: Vec::new() });
        }
        let line = lines.iter_mut().find(|line| line.name == name).expect("pushed just now");
        for pair in 0..self.count {
            // Each goes first as often as second.
            if pair % 2 == 0 {
                line.kernel.push(time(repeat, &mut kernel));
                line.twin.push(time(repeat, &mut twin));
            } else {
                line.twin.push(time(repeat, &mut twin));
                line.kernel.push(time(repeat, &mut kernel));
            }
        }
    }
}

/// Asserts that two results agree.
pub(crate) fn same(name: &str, ours: &[f32], theirs: &[f32], tolerance: f32) {
    assert_eq!(ours.len(), theirs.len(), "{name}: lengths");
    let worst = ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(worst <= tolerance, "{name}: kernel and twin differ by {worst}");
}
