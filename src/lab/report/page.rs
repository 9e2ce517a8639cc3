//! The page as a file.

use serde_json::json;

use super::Findings;
use super::html::inline;
use super::sections::sections;
use crate::lab::errors::LabError;
use crate::lab::map::escaped;
use crate::lab::scene::size;

/// How the page looks: on a screen by day and by night, on a phone and on paper.
const STYLE: &str = include_str!("style.css");

/// What a browser may fetch for the page: nothing.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The whole page.
pub(super) fn page(findings: &Findings) -> Result<String, LabError> {
    let report = &findings.report;
    let title = escaped(&format!("{}, {}: layouts compared", report.solver, report.scene));
    let lead = inline(&format!(
        "One and the same simulation, {} with {}, was run in {}. A layout says where in memory the numbers of each particle lie; it changes nothing in the results, \
         which were checked, but it changes how long a step takes. This page tells which layout is the fastest here, by how much, and how sure that is.",
        findings.solver.about,
        size(report.particles, "", &report.grid),
        match findings.ranking.len() {
            1 => "one layout".to_string(),
            count => format!("{count} ways of laying its data out"),
        }
    ));
    let sections = sections(findings)?;
    let links: String = sections
        .iter()
        .map(|section| format!("<li><a href=\"#{}\">{}</a></li>\n", section.id, escaped(section.title)))
        .collect();
    let body: String = sections
        .iter()
        .map(|section| {
            let (id, title) = (section.id, escaped(section.title));
            format!("<section id=\"{id}\" aria-labelledby=\"{id}-title\">\n<h2 id=\"{id}-title\">{title}</h2>\n{}</section>\n", section.body.text())
        })
        .collect();
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header>\n<h1>{title}</h1>\n<p>{lead}</p>\n<nav aria-label=\"parts\"><ul>\n{links}</ul></nav>\n</header>\n<main>\n{body}</main>\n\
         <script type=\"application/json\" id=\"data\">{}</script>\n</body>\n</html>\n",
        data(findings)?
    ))
}

/// The numbers of the page for programs: the results as `bench --json` writes them, and all repetitions.
fn data(findings: &Findings) -> Result<String, LabError> {
    let data = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "report": findings.report,
        "samples_ms": findings.samples,
    });
    let text = serde_json::to_string(&data).map_err(|error| LabError::failure(error.to_string()))?;
    // So that no text in it ends the element.
    Ok(text.replace('<', "\\u003c"))
}
