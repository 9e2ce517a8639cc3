//! `allotrope report`: the comparison of layouts as one page of HTML, for people who have read nothing else. It needs no network and no
//! other file.
//!
//! What was measured is in `Findings`; each part of the page is a `Section` that is made of them, a file in `sections/` and a line in its
//! list.

mod base64;
mod commands;
mod date;
mod findings;
mod html;
mod maps;
mod page;
mod pictures;
mod ranking;
mod sections;
mod surroundings;
#[cfg(test)]
mod tests;

use std::path::PathBuf;

use super::bench::text::text;
use super::errors::LabError;
use super::{bench, output};
use findings::Findings;
use html::Html;

/// The file that is written.
pub const FILE: &str = "report.html";

/// What is to be reported.
#[derive(Debug)]
pub struct Plan {
    /// What is compared.
    pub bench: bench::Plan,
    /// The options by which the scene was asked for, as words of a command.
    pub scene: Vec<String>,
    /// All words of the command behind the program's name.
    pub command: Vec<String>,
    /// About how many seconds the comparison takes, if no steps are asked for, and as many again the sweep.
    pub budget: f64,
    /// Whether the layouts are compared at other sizes too.
    pub sweep: bool,
    /// What a step touches, to be shown.
    pub counts: Option<super::counts::Report>,
    /// The folder for the page.
    pub out: PathBuf,
}

/// Compares the layouts, prints what was found, and writes the page.
///
/// # Errors
/// If the scene cannot be built, a step is refused, layouts end in different states, the scene cannot be in other sizes where that is
/// asked for, or the page cannot be written.
pub fn report(plan: &Plan) -> Result<(), LabError> {
    output::folder(&plan.out)?;
    let findings = Findings::gather(plan)?;
    let path = plan.out.join(FILE);
    output::write(&path, page::page(&findings)?.as_bytes())?;
    let verdict = sections::verdict(&findings.ranking, findings.about.repetitions);
    output::print(&format!("{}\n{verdict}\nwritten to {}\n", text(&findings.report, &findings.about), path.display()))
}
