//! The table of all layouts, the fastest first.

use super::super::html::Table;
use super::{Findings, Html, Section, code, listed};
use crate::lab::errors::LabError;
use crate::lab::table::{error_digits, four_digits, mebibytes};

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let Findings { ranking, about, report, solver, .. } = findings;
    let headline = [
        "layout",
        "ms a step",
        "ratio to the best",
        "its 95 % interval",
        "95 % interval of ms",
        "spread",
        "ns a particle",
        "memory in MiB",
        "state error in m",
        "outliers",
        "slowest over median",
    ];
    let rows = ranking.iter().enumerate().map(|(place, one)| {
        let cells = vec![
            format!("{}. `{}`{}", place + 1, one.name, if place > 0 && one.is_level { " (level)" } else { "" }),
            four_digits(one.ms),
            format!("{:.3}", one.ratio),
            if place == 0 {
                "\u{2013}".into()
            } else {
                format!("{:.3} to {:.3}", one.ratio_interval[0], one.ratio_interval[1])
            },
            format!("{} to {}", four_digits(one.interval[0]), four_digits(one.interval[1])),
            format!("{:.1} %", 100.0 * one.spread),
            format!("{:.1}", one.ms * 1e6 / report.particles as f64),
            mebibytes(one.bytes as u64),
            error_digits(one.state_error),
            format!("{} of {}", one.outliers, about.repetitions),
            format!("{:.2}", one.slowest),
        ];
        (cells, place == 0)
    });
    let caption = format!("{}, {}: the fastest first", report.solver, report.scene);
    let table = Table { caption, headline: headline.map(String::from).into(), words: 1, rows: rows.collect() };
    let level: Vec<&String> = ranking.iter().skip(1).filter(|one| one.is_level).map(|one| &one.name).collect();
    let mut body = Html::default().table(&table);
    if !level.is_empty() {
        body = body.paragraph(&format!("Not told from the best by these measurements: {}.", listed(&code(level))));
    }
    let lost: Vec<&String> = ranking.iter().filter(|one| !one.is_level).map(|one| &one.name).collect();
    if !lost.is_empty() {
        body = body.paragraph(&format!("Slower than the best beyond the noise: {}.", listed(&code(lost))));
    }
    if !about.left_out.is_empty() {
        let left_out: Vec<String> = about.left_out.iter().map(|(layout, why)| format!("`{layout}`: {why}")).collect();
        body = body.paragraph("Left out:").list(&left_out);
    }
    body = body.command(
        "The table is made again, in the order of its rows in the command, by:",
        &findings.commands.bench(about.steps),
    );
    body = body.heading("The layouts");
    let layouts = solver.layouts.iter().filter(|info| ranking.iter().any(|one| one.layout == info.name));
    let layouts: Vec<_> = layouts.map(|info| (format!("`{}`", info.name), info.about.to_string())).collect();
    body = body.terms(&layouts).heading("The columns").terms(&columns());
    Ok(Some(Section { id: "ranking", title: "All layouts, ranked", body }))
}

/// What the columns say.
fn columns() -> Vec<(String, String)> {
    let columns = [
        (
            "ms a step",
            "milliseconds that one step of the simulation takes: the median, of which half of the repetitions are faster and half slower",
        ),
        (
            "95 % intervals",
            "where that median, or that ratio, lies with 95 % confidence as far as noise within this run goes; of ratios by resampling the paired repetitions. Where that of a ratio reaches down to 1, these measurements tell no difference: level",
        ),
        ("spread", "the width of the middle half of the repetitions, over their median"),
        ("ratio to the best", "how many times as long a step takes as with the fastest layout"),
        ("ns a particle", "billionths of a second a step, for each particle"),
        ("memory", "of all that the simulation holds, in units of 1024 times 1024 bytes"),
        (
            "state error",
            "by how much a position differs at the end from that with the layout that was asked for first, at most: the order of additions may differ, nothing else",
        ),
        (
            "outliers",
            "repetitions farther from the middle half than one and a half times its width; medians hardly feel them",
        ),
        ("slowest over median", "how many times as long the slowest repetition took as the median one"),
    ];
    columns.map(|(name, about)| (name.to_string(), about.to_string())).into()
}
