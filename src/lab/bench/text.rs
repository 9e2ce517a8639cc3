//! The report as people read it.

use super::report::{Report, Row};
use crate::lab::hardware::{Event, short};
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
    /// What processor and system were asked to count and did not, and why.
    pub(in crate::lab) refused: Option<String>,
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
    if report.rows.iter().any(|row| !row.counted.is_empty()) {
        text += &format!("\na step on all threads, as processor and system counted it:\n\n{}", counted(report).text());
    }
    if let Some(refused) = &about.refused {
        text += &format!("\n{refused}\n");
    }
    if !about.left_out.is_empty() {
        text.push('\n');
    }
    about.left_out.iter().fold(text, |text, (layout, why)| text + &format!("left out: {layout}; {why}\n"))
}

/// What was counted, a column an event; and instructions a cycle where both are known.
pub(in crate::lab) fn counted(report: &Report) -> Table {
    let known = |event: &Event| report.rows.iter().any(|row| row.counted.get(event.name()).is_some());
    let events: Vec<Event> = Event::ALL.into_iter().filter(known).collect();
    let rate = |row: &Row| {
        Some(row.counted.get(Event::Instructions.name())? / row.counted.get(Event::Cycles.name())?.max(1.0))
    };
    let has_rate = report.rows.iter().any(|row| rate(row).is_some());
    let names = events.iter().map(|event| event.name());
    let mut table = Table::new(
        ["layout", "schedule"].into_iter().chain(names).chain(has_rate.then_some("instructions a cycle")),
        2,
    );
    for row in &report.rows {
        let cell = |event: &Event| row.counted.get(event.name()).map_or_else(|| "-".to_string(), short);
        let rate = has_rate.then(|| rate(row).map_or_else(|| "-".to_string(), |rate| format!("{rate:.2}")));
        let words = [row.layout.clone(), row.schedule.clone()];
        table.row(words.into_iter().chain(events.iter().map(cell)).chain(rate));
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::bench::Named;

    fn report(grid: Vec<usize>) -> Report {
        let row = Row {
            layout: "flat".into(),
            schedule: "auto".into(),
            ms_per_step: 0.5,
            spread: 0.01,
            kernels: Named(vec![("forces".into(), 0.3), ("update".into(), 0.1)]),
            bytes: 1 << 20,
            state_error: 0.0,
            counted: Named::default(),
        };
        let isa = "baseline".into();
        Report { solver: "net".into(), scene: "cloth".into(), particles: 1000, grid, threads: 1, isa, rows: vec![row] }
    }

    fn about(refused: Option<String>) -> About {
        About { verified: 10, agreement: 0.0, repetitions: 2, steps: 20, time: 0.1, left_out: Vec::new(), refused }
    }

    #[test]
    fn nodes_are_told_where_there_is_a_grid() {
        let about = about(None);
        let first = |grid| text(&report(grid), &about).lines().next().unwrap_or_default().to_string();
        assert_eq!(first(vec![]), "net cloth: 1000 particles");
        assert_eq!(first(vec![8, 4]), "net cloth: 1000 particles, 8 x 4 nodes");
        assert!(text(&report(vec![]), &about).contains("75 %    25 %"), "shares of kernels");
    }

    #[test]
    fn what_was_counted_stands_in_a_table_of_its_own() {
        let about = about(Some("not counted: page faults (not permitted)".into()));
        let mut report = report(vec![]);
        assert!(!text(&report, &about).contains("as processor and system counted it"));
        report.rows[0].counted = Named(vec![("cycles".into(), 2e6), ("instructions".into(), 5e6)]);
        let text = text(&report, &about);
        let table = text.split_once("as processor and system counted it:\n\n").expect("a table").1;
        let cells: Vec<&str> =
            table.lines().nth(1).expect("a row").split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
        assert_eq!(cells, ["flat", "auto", "2.000 M", "5.000 M", "2.50"], "{table}");
        assert!(text.ends_with("\nnot counted: page faults (not permitted)\n"), "{text}");
    }
}
