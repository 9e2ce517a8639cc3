//! Where the records lie in memory.

use super::{Findings, Html, Section, code, listed};
use crate::lab::errors::LabError;
use crate::lab::map::escaped;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let mut body = Html::default();
    if !findings.maps.is_empty() {
        body = body.paragraph(
            "A row is a line of 64 bytes, which is what a processor fetches from memory at once; each member of a record has its colour, and the numbers above are the indices of \
             its elements. What is used together should lie together: colours that are fetched and not used cost time. Of each field the first lines are drawn, and those where \
             the values of a member begin, as they lay at the end of this run.",
        );
    }
    let mut fields: Vec<&String> = findings.maps.iter().map(|one| &one.field).collect();
    fields.dedup();
    for field in fields {
        let same = findings.maps.iter().filter(|one| one.field == *field);
        let figures: String = same
            .map(|one| {
                let caption = super::super::html::inline(&format!("in {}", listed(&code(&one.layouts))));
                format!("<figure><figcaption>{caption}</figcaption>{}</figure>\n", one.svg)
            })
            .collect();
        body = body
            .heading(field)
            .markup(&format!("<div class=\"maps\" data-field=\"{}\">\n{figures}</div>", escaped(field)));
    }
    if !findings.unmapped.is_empty() {
        let names = listed(&code(&findings.unmapped));
        body = body.paragraph(&format!("Not drawn, since the solver does not tell where their records lie: {names}."));
    }
    body = body.command(
        "The maps are drawn again with the page; a layout of any record of your own is drawn by, for example:",
        "allotrope map 'x: Vec2, v: Vec2, m: f32' Aos Soa 'AoSoA<16>' --html layouts.html",
    );
    Ok(Some(Section { id: "maps", title: "Where the records lie in memory", body }))
}
