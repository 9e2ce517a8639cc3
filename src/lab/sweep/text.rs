//! A sweep as people read it.

use std::path::Path;

use super::{Point, Record, chart};
use crate::lab::scene::size;
use crate::lab::table::{Table, error_digits, four_digits};

/// What is swept, and how much of it is there already.
pub(super) fn start(record: &Record, points: usize, done: usize) -> String {
    let there = match done {
        0 => String::new(),
        done => format!("; {done} of them are there already"),
    };
    format!("{}, {}: {points} points along `{}`{there}", record.title(), record.machine(), record.axis().name())
}

/// A line about a point that was just measured, as the `n`-th of `points`.
pub(super) fn point(record: &Record, value: &str, n: usize, points: usize, left_out: &[&str]) -> String {
    let Some(Point { report, .. }) = record.point(value) else { return String::new() };
    let best = report.rows.iter().min_by(|a, b| a.ms_per_step.total_cmp(&b.ms_per_step));
    let best = best.map_or(String::new(), |row| {
        format!(", best {} with {} ms/step", chart::name(record, row), four_digits(row.ms_per_step))
    });
    let left_out = match left_out {
        [] => String::new(),
        names => format!("; left out, since they do not fit: {}", names.join(", ")),
    };
    let what = record.axis().named(value);
    format!("point {n} of {points}: {what}: {}{best}{left_out}\n", size(report.particles, "", &report.grid))
}

/// All layouts at all points, and where the files are.
pub(super) fn table(record: &Record, out: &Path) -> String {
    let headline = [record.axis().name(), "layout", "schedule", "ms/step", "spread", "ns/particle", "ratio"];
    let mut table = Table::new(headline, 3);
    for Point { value, report, .. } in &record.points {
        let best = report.rows.iter().map(|row| row.ms_per_step).fold(f64::INFINITY, f64::min);
        for row in &report.rows {
            table.row([
                value.clone(),
                row.layout.clone(),
                row.schedule.clone(),
                four_digits(row.ms_per_step),
                format!("{:.1} %", 100.0 * row.spread),
                format!("{:.1}", row.ms_per_step * 1e6 / report.particles as f64),
                format!("{:.2}", row.ms_per_step / best),
            ]);
        }
    }
    let agreement = record.points.iter().map(|point| point.agreement).fold(0.0, f64::max);
    format!(
        "\nat each point all layouts came to the same state before anything was timed: positions differed by at most \
         {}\n\n{}\nsweep.json, sweep.csv and sweep.svg in {}\n",
        error_digits(agreement),
        table.text(),
        out.display()
    )
}
