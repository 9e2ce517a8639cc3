//! The report as people read it.

use super::report::Report;
use crate::lab::machine;
use crate::lab::scene::size;
use crate::lab::table::{Table, four_digits};

/// What the table tells beside the report.
pub(super) struct About {
    pub(super) verified: u64,
    pub(super) agreement: f64,
    pub(super) repetitions: u64,
    pub(super) steps: u64,
    pub(super) time: f64,
}

/// Machine and scene, what was checked, and the table.
pub(super) fn text(report: &Report, about: &About) -> String {
    let mut text = format!(
        "{} {}: {}\n{}, {} threads, {}\n",
        report.solver,
        report.scene,
        size(report.particles, "", &report.grid),
        machine::processor(),
        report.threads,
        report.isa
    );
    if report.rows.len() > 1 {
        text += &format!(
            "all {} end in the same state: after {} steps positions differ by at most {}\n",
            report.rows.len(),
            about.verified,
            error_digits(about.agreement)
        );
    }
    text += &format!(
        "{} steps each, in {} interleaved repetitions, to {:.4} s\n\n",
        about.steps, about.repetitions, about.time
    );

    let kernels: Vec<&str> = report.rows[0].kernels.0.iter().map(|(name, _)| name.as_str()).collect();
    let mut headline = vec!["layout", "schedule", "ms/step", "spread"];
    headline.extend(&kernels);
    headline.extend(["ns/particle", "MiB", "state error", "ratio"]);
    let best = report.rows.iter().map(|row| row.ms_per_step).fold(f64::INFINITY, f64::min);
    let mut table = Table::new(headline, 2);
    for row in &report.rows {
        let total: f64 = row.kernels.0.iter().map(|(_, time)| time).sum();
        let mut cells = vec![
            row.layout.clone(),
            row.schedule.clone(),
            four_digits(row.ms_per_step),
            format!("{:.1} %", 100.0 * row.spread),
        ];
        cells.extend(row.kernels.0.iter().map(|(_, time)| format!("{:.0} %", 100.0 * time / total)));
        cells.push(format!("{:.1}", row.ms_per_step * 1e6 / report.particles as f64));
        cells.push(format!("{:.2}", row.bytes as f64 / f64::from(1 << 20)));
        cells.push(error_digits(row.state_error));
        cells.push(format!("{:.2}", row.ms_per_step / best));
        table.row(cells);
    }
    text + &table.text()
}

fn error_digits(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}
