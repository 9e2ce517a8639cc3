//! Where and how it was measured.

use super::{Findings, Html, Section};
use crate::lab::errors::LabError;
use crate::lab::statistics::RESAMPLES;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let (report, about, here) = (&findings.report, &findings.about, &findings.surroundings);
    let mut terms = here.facts.clone();
    terms.push(("Threads".into(), report.threads.to_string()));
    terms.push(("Instruction set".into(), format!("`{}`", report.isa)));
    if let Some(load) = here.load {
        terms.push(("Load before".into(), format!("{load:.2} programs on average over a minute")));
    }
    let method = [
        format!(
            "Each layout begins the scene anew. All take {} steps, and are compared: the page is not made where one differs by more than rounding.",
            about.verified
        ),
        format!(
            "Then all take {} more steps, to {:.4} s simulated, in {} interleaved repetitions; each layout begins a round in turn.",
            about.steps, about.time, about.repetitions
        ),
        "Sorting of particles, which most steps do not have, is spread over all steps.".into(),
        format!(
            "Intervals of ratios are those of {RESAMPLES} bootstrap resamples of paired repetitions; intervals of medians are those of order statistics, whatever the distribution."
        ),
        "All numbers stand as JSON in the page itself, in the element `data`, every repetition among them.".into(),
    ];
    let body = Html::default()
        .terms(&terms)
        .heading("How it was measured")
        .list(&method)
        .command("All of it is done again by:", &findings.commands.report());
    Ok(Some(Section { id: "method", title: "Machine and method", body }))
}
