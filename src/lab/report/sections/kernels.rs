//! Where the time goes: a bar a layout with the share of each kernel.

use super::super::html::{Table, inline};
use super::super::ranking::Ranked;
use super::{Findings, Html, Section};
use crate::lab::errors::LabError;
use crate::lab::table::four_digits;

/// Units across a bar's picture.
const WIDTH: f64 = 1000.0;

/// Colours that there are.
const COLOURS: usize = 8;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let ranking = &findings.ranking;
    let Some(best) = ranking.first() else { return Ok(None) };
    let longest = ranking.iter().flat_map(|one| [one.ms, one.interval[1]]).fold(f64::MIN_POSITIVE, f64::max);
    let bars: String = ranking.iter().enumerate().map(|(place, one)| bar(one, longest, place == 0)).collect();
    let legend: String = best
        .kernels
        .iter()
        .enumerate()
        .map(|(n, (name, _))| {
            let colour = n % COLOURS;
            format!(
                "<li><svg viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect class=\"kernel{colour}\" width=\"1\" height=\"1\"/></svg>{}</li>",
                inline(name)
            )
        })
        .collect();
    let headline = ["layout".to_string()].into_iter().chain(best.kernels.iter().map(|(name, _)| format!("{name}, ms")));
    let rows = ranking.iter().enumerate().map(|(place, one)| {
        let total: f64 = one.kernels.iter().map(|(_, time)| time).sum();
        let shares =
            one.kernels.iter().map(|(_, time)| format!("{} ({:.0} %)", four_digits(*time), 100.0 * time / total));
        ([format!("`{}`", one.name)].into_iter().chain(shares).collect(), place == 0)
    });
    let table = Table {
        caption: "milliseconds a step in each part, and its share".into(),
        headline: headline.collect(),
        words: 1,
        rows: rows.collect(),
    };
    let body = Html::default()
        .paragraph("A step has parts, the kernels. The longer a bar, the slower the layout; its colours are the shares of the parts. The thin line is the 95 % interval of the whole.")
        .markup(&format!("<ul class=\"legend\">{legend}</ul>\n<div class=\"bars\">\n{bars}</div>"))
        .table(&table)
        .command("Bars and table are made again by:", &findings.commands.bench(findings.about.steps));
    Ok(Some(Section { id: "kernels", title: "Where the time goes", body }))
}

/// The bar of a layout, where `longest` milliseconds reach from side to side.
fn bar(one: &Ranked, longest: f64, is_best: bool) -> String {
    let at = |time: f64| WIDTH * time / longest;
    let total: f64 = one.kernels.iter().map(|(_, time)| time).sum();
    let (mut left, mut parts, mut words) = (0.0, String::new(), Vec::new());
    for (n, (name, time)) in one.kernels.iter().enumerate() {
        let share = if total > 0.0 { time / total } else { 0.0 };
        let width = at(one.ms) * share;
        let colour = n % COLOURS;
        parts +=
            &format!("<rect class=\"kernel{colour}\" x=\"{left:.2}\" y=\"0\" width=\"{width:.2}\" height=\"20\"/>");
        words.push(format!("{name} {:.0} %", 100.0 * share));
        left += width;
    }
    let [low, high] = one.interval.map(at);
    let label = inline(&format!("{}: {} ms, {}", one.name, four_digits(one.ms), words.join(", ")));
    format!(
        "<div class=\"bar{}\"><p>{} <span>{} ms, {:.2} x</span></p><svg viewBox=\"0 0 {WIDTH} 20\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{label}\">{parts}\
         <path class=\"whisker\" fill=\"none\" d=\"M{low:.2} 10H{high:.2}M{low:.2} 5V15M{high:.2} 5V15\"/></svg></div>\n",
        if is_best { " best" } else { "" },
        inline(&format!("`{}`", one.name)),
        four_digits(one.ms),
        one.ratio,
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::ranking::rank;
    use super::super::super::tests::{report, row};
    use super::*;

    #[test]
    fn parts_are_as_long_as_their_times() {
        let ranking = rank(&report(vec![row("aos", 1.0), row("soa", 2.0)]), &[vec![1.0; 11], vec![2.0; 11]]);
        let bar = bar(&ranking[0], 2.0, true);
        assert!(
            bar.contains("x=\"0.00\" y=\"0\" width=\"375.00\"")
                && bar.contains("x=\"375.00\" y=\"0\" width=\"125.00\""),
            "{bar}"
        );
        assert!(bar.contains("aria-label=\"aos: 1.000 ms, scatter 75 %, grid 25 %\""), "{bar}");
    }
}
