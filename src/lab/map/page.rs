//! Pictures of several layouts on a page of HTML, which needs no network and no program.

use std::fmt::Write;

use super::paper::escaped;

/// What a page shows of one layout.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    /// The layout.
    pub name: String,
    /// What it amounts to: see [`summary`](super::summary).
    pub summary: String,
    /// The picture: see [`Drawing::svg`](super::Drawing::svg).
    pub svg: String,
}

const STYLE: &str = "\
body { font-family: 'DejaVu Sans', Verdana, Helvetica, Arial, sans-serif; color: #111827; background: #fff; margin: 1rem; line-height: 1.4; }
h1 { font-size: 1.3rem; overflow-wrap: anywhere; }
h2 { font-size: 1rem; margin: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; }
th, td { text-align: left; padding: 0.25rem 1rem 0.25rem 0; border-bottom: 1px solid #d1d5db; vertical-align: top; overflow-wrap: anywhere; }
main { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 1rem; margin-top: 1rem; align-items: start; }
figure { margin: 0; border: 1px solid #d1d5db; padding: 0.25rem; }
svg { display: block; width: 100%; height: auto; }
@media print { body { margin: 0; } main { display: block; } figure { border: 0; break-inside: avoid; } figure + figure { break-before: page; } svg { max-height: 24cm; } }
";

/// A page with a headline, a table of the layouts, and their pictures side by side where there is room.
///
/// ```
/// use allotrope_lab::lab::map::{Drawing, Sheet, TextMap, page, summary};
///
/// let sheets = ["Aos", "Soa"].map(|layout| {
///     let map = TextMap::new("x: Vec2, m: f32", layout, Some(&[20]), None).unwrap();
///     let drawing = Drawing { title: layout.into(), ..Drawing::default() };
///     Sheet { name: layout.into(), summary: summary(&map), svg: drawing.svg(&map) }
/// });
/// let html = page("x: Vec2, m: f32", &sheets);
/// assert!(html.starts_with("<!DOCTYPE html>") && html.matches("<svg ").count() == 2);
/// ```
pub fn page(title: &str, sheets: &[Sheet]) -> String {
    let title = escaped(title);
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, \
         initial-scale=1\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n<table>\n\
         <tr><th>layout</th><th>memory</th></tr>\n"
    );
    for (n, Sheet { name, summary, .. }) in sheets.iter().enumerate() {
        let _ =
            writeln!(html, "<tr><td><a href=\"#map{n}\">{}</a></td><td>{}</td></tr>", escaped(name), escaped(summary));
    }
    html.push_str("</table>\n<main>\n");
    for (n, Sheet { svg, .. }) in sheets.iter().enumerate() {
        let _ = writeln!(html, "<figure id=\"map{n}\">\n{svg}</figure>");
    }
    html.push_str("</main>\n</body>\n</html>\n");
    html
}
