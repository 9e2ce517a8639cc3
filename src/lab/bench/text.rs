//! The report as people read it.

use super::report::Report;
use crate::lab::machine;
use crate::lab::scene::size;
use crate::lab::table::{Table, error_digits, four_digits, mebibytes};

/// What the table tells beside the report.
pub(in crate::lab) struct About {
    pub(in crate::lab) verified: u64,
    pub(in crate::lab) agreement: f64,
    pub(in crate::lab) repetitions: u64,
    pub(in crate::lab) steps: u64,
    pub(in crate::lab) time: f64,
    /// The layouts that the scene does not fit, and why, where all others are compared.
    pub(in crate::lab) left_out: Vec<(&'static str, &'static str)>,
}

/// Machine and scene, what was checked, and the table.
pub(in crate::lab) fn text(report: &Report, about: &About) -> String {
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
        cells.push(mebibytes(row.bytes as u64));
        cells.push(error_digits(row.state_error));
        cells.push(format!("{:.2}", row.ms_per_step / best));
        table.row(cells);
    }
    text += &table.text();
    if !about.left_out.is_empty() {
        text.push('\n');
    }
    about.left_out.iter().fold(text, |text, (layout, why)| text + &format!("left out: {layout}; {why}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::bench::{Kernels, Row};

    fn report(grid: Vec<usize>) -> Report {
        let row = Row {
            layout: "flat".into(),
            schedule: "auto".into(),
            ms_per_step: 0.5,
            spread: 0.01,
            kernels: Kernels(vec![("forces".into(), 0.3), ("update".into(), 0.1)]),
            bytes: 1 << 20,
            state_error: 0.0,
        };
        let isa = "baseline".into();
        Report { solver: "net".into(), scene: "cloth".into(), particles: 1000, grid, threads: 1, isa, rows: vec![row] }
    }

    #[test]
    fn nodes_are_told_where_there_is_a_grid() {
        let about = About { verified: 10, agreement: 0.0, repetitions: 2, steps: 20, time: 0.1, left_out: Vec::new() };
        let first = |grid| text(&report(grid), &about).lines().next().unwrap_or_default().to_string();
        assert_eq!(first(vec![]), "net cloth: 1000 particles");
        assert_eq!(first(vec![8, 4]), "net cloth: 1000 particles, 8 x 4 nodes");
        assert!(text(&report(vec![]), &about).contains("75 %    25 %"), "shares of kernels");
    }
}
