//! Charts of sweeps: a line for each layout over what can be counted, else a bar for each.

use super::{Axis, Point, Record};
use crate::lab::bench::Row;
use crate::lab::chart::{Bar, BarChart, Line, LineChart};
use crate::lab::errors::LabError;
use crate::lab::table::four_digits;

/// The text of an SVG file.
pub(super) fn svg(record: &Record) -> Result<String, LabError> {
    match record.axis() {
        Axis::Size => lines(record, "particles", "nanoseconds a particle and step", |point, row| {
            [point.report.particles as f64, row.ms_per_step * 1e6 / point.report.particles as f64]
        }),
        Axis::ParticlesPerCell => lines(record, "particles a cell", "nanoseconds a particle and step", |point, row| {
            let density = point.value.parse().unwrap_or(f64::NAN);
            [density, row.ms_per_step * 1e6 / point.report.particles as f64]
        }),
        Axis::Sparsity => {
            lines(record, "part of the cells that holds particles", "milliseconds a step", |point, row| {
                [point.value.parse().unwrap_or(f64::NAN), row.ms_per_step]
            })
        }
        Axis::Threads => {
            lines(record, "threads", "milliseconds a step", |point, row| [point.report.threads as f64, row.ms_per_step])
        }
        Axis::Order => bars(record),
    }
}

/// A layout, with its schedule if there are several.
pub(super) fn name(record: &Record, row: &Row) -> String {
    if record.has_schedules() { format!("{}, {}", row.layout, row.schedule) } else { row.layout.clone() }
}

fn lines(
    record: &Record,
    across: &str,
    upwards: &str,
    at: impl Fn(&Point, &Row) -> [f64; 2],
) -> Result<String, LabError> {
    let mut lines: Vec<Line> = Vec::new();
    for point in &record.points {
        for row in &point.report.rows {
            let (name, place) = (name(record, row), at(point, row));
            match lines.iter_mut().find(|line| line.name == name) {
                Some(line) => line.points.push(place),
                None => lines.push(Line { name, points: vec![place] }),
            }
        }
    }
    let (title, subtitle) = (record.title(), record.machine());
    LineChart { title, subtitle, across: across.into(), upwards: upwards.into(), lines }.svg()
}

/// All layouts at all points, the fastest accented.
fn bars(record: &Record) -> Result<String, LabError> {
    let rows = || record.points.iter().flat_map(|point| point.report.rows.iter().map(move |row| (point, row)));
    let best = rows().map(|(_, row)| row.ms_per_step).fold(f64::INFINITY, f64::min);
    let bar = |(point, row): (&Point, &Row)| {
        let half = 0.5 * row.spread * row.ms_per_step;
        Bar {
            name: format!("{}, {}", name(record, row), point.value),
            value: row.ms_per_step,
            range: [row.ms_per_step - half, row.ms_per_step + half],
            label: format!("{} ms", four_digits(row.ms_per_step)),
            note: format!("{:.2}", row.ms_per_step / best),
            accented: row.ms_per_step == best,
        }
    };
    let bars = rows().map(bar).collect();
    let subtitle = format!("{}; particles sorted every so many steps, 0: never", record.machine());
    BarChart { title: record.title(), subtitle, axis: "milliseconds a step".into(), bars }.svg()
}
