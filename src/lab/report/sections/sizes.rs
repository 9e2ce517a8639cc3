//! The same comparison at other sizes, where it was asked for.

use super::super::findings::Swept;
use super::super::html::{Table, svg_part};
use super::{Findings, Html, Section};
use crate::lab::errors::LabError;

/// The number of the chart among the pictures of a page: far from those of maps.
const NUMBER: usize = 10_000;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let Some(Swept { record, points, steps }) = &findings.sweep else { return Ok(None) };
    let names: Vec<&String> = findings.ranking.iter().map(|one| &one.layout).collect();
    let mut rows = Vec::new();
    for point in &record.points {
        let best = point.report.rows.iter().min_by(|a, b| a.ms_per_step.total_cmp(&b.ms_per_step));
        let Some(best) = best else { continue };
        let slowest = point.report.rows.iter().map(|row| row.ms_per_step).fold(0.0, f64::max);
        let each = |ms: f64| format!("{:.1}", ms * 1e6 / point.report.particles as f64);
        let schedule = if findings.report.rows.iter().any(|row| row.schedule != best.schedule) {
            format!(" ({})", best.schedule)
        } else {
            String::new()
        };
        let cells = vec![
            point.report.particles.to_string(),
            format!("`{}`{schedule}", best.layout),
            each(best.ms_per_step),
            each(slowest),
            format!("{:.2}", slowest / best.ms_per_step),
        ];
        let same = names.first().is_some_and(|first| **first == best.layout);
        rows.push((cells, same));
    }
    let headline = ["particles", "fastest layout", "ns a particle", "of the slowest", "ratio"].map(String::from);
    let caption =
        "the fastest layout at each size; rows stand out where it is that of the whole comparison".to_string();
    let table = Table { caption, headline: headline.into(), words: 2, rows };
    let body = Html::default()
        .paragraph("How long a step takes for each particle, over the number of particles; the grid grows in proportion, where there is one. Lines that cross are layouts of which one wins where little data fits near the processor, the other where much does not.")
        .markup(&format!("<div class=\"chart\" tabindex=\"0\" role=\"region\" aria-label=\"chart over sizes\">{}</div>", svg_part(&record.chart()?, NUMBER)))
        .table(&table)
        .command("Chart and table are made again, in the folder `sizes`, by:", &findings.commands.sweep(points, *steps));
    Ok(Some(Section { id: "sizes", title: "At other sizes", body }))
}
