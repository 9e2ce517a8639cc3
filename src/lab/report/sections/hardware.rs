//! What processor and system counted, where they let a program count.

use super::super::html::Table;
use super::{Findings, Html, Section};
use crate::lab::bench::{Report, text};
use crate::lab::errors::LabError;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let body = shown(&findings.report, findings.about.refused.as_deref(), &findings.commands.bench_hardware());
    Ok(Some(Section { id: "hardware", title: "What the processor counted", body }))
}

fn shown(report: &Report, refused: Option<&str>, command: &str) -> Html {
    let mut html = Html::default().paragraph(
        "Processors count what happens in them while programs run. Where few instructions are done in a cycle and many misses are counted, a layout waits for memory; where many are, it \
         computes. A step of each layout, on all threads, is the mean over all repetitions.",
    );
    if report.rows.iter().any(|row| !row.counted.is_empty()) {
        let (headline, rows) = text::counted(report).into_parts();
        let rows = rows.into_iter().map(|mut cells| {
            cells[0] = format!("`{}`", cells[0]);
            (cells, false)
        });
        let caption = "a step on all threads".into();
        html = html.table(&Table { caption, headline, words: 2, rows: rows.collect() });
    }
    if let Some(refused) = refused {
        html = html.paragraph(&format!("On this machine they were {refused}."));
    }
    html.command("Counted again by:", command)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::bench::{Named, Row};

    fn report(counted: Vec<(String, f64)>) -> Report {
        let row = Row {
            layout: "aos+row".into(),
            schedule: "auto".into(),
            ms_per_step: 0.5,
            spread: 0.01,
            kernels: Named::default(),
            bytes: 1 << 20,
            state_error: 0.0,
            counted: Named(counted),
        };
        let (solver, scene, isa) = ("mpm".into(), "mpm88".into(), "avx2".into());
        Report { solver, scene, particles: 8192, grid: vec![128, 128], threads: 2, isa, rows: vec![row] }
    }

    #[test]
    fn what_was_counted_and_what_was_not_is_told() {
        let command = "allotrope bench mpm --hardware";
        let html = shown(&report(vec![("cycles".into(), 2e6), ("instructions".into(), 3e6)]), None, command);
        let text = html.text();
        assert!(text.contains("<code>aos+row</code>") && text.contains("<td class=\"number\">1.50</td>"), "{text}");
        assert!(text.contains("--hardware") && !text.contains("not counted"), "{text}");
        let html = shown(&report(Vec::new()), Some("not counted: cycles (operation not supported)"), command);
        let text = html.text();
        assert!(text.contains("On this machine they were not counted: cycles (operation not supported)."), "{text}");
        assert!(!text.contains("<table"), "{text}");
    }
}
