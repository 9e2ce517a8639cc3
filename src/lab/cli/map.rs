//! `allotrope map`.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;

use super::values;
use crate::lab::errors::LabError;
use crate::lab::map::{Drawing, Mapped, Sheet, TextMap, page, summary};
use crate::lab::output;

/// What is asked of `allotrope map`.
#[derive(Args, Debug)]
pub struct MapArguments {
    /// The members of a record and their types, `x: Vec2, m: f32`, or one type
    #[arg(value_name = "RECORD")]
    record: String,
    /// A layout, `dense(ij).dense(ij, 4).aos` or `Blocked<4>`; with `--html` several
    #[arg(value_name = "LAYOUT", required = true)]
    layouts: Vec<String>,
    /// Elements along each axis [default: few]
    #[arg(long, value_name = "N,M", value_parser = values::shape)]
    shape: Option<Arc<[usize]>>,
    /// What is active in a sparse layout: all, none, diagonal, disc, random:PERCENT, or boxes of indices [default: diagonal]
    #[arg(long, value_name = "WHAT", allow_hyphen_values = true)]
    active: Option<String>,
    /// The most lines of 64 bytes that are drawn of a layout
    #[arg(long, value_name = "N", default_value = "24", value_parser = clap::value_parser!(u16).range(1..=2000))]
    lines: u16,
    /// Writes the picture to a file [default: it is printed]
    #[arg(long, value_name = "FILE", conflicts_with = "html")]
    out: Option<PathBuf>,
    /// Writes a page with the pictures of all the layouts, side by side
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
}

impl MapArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        if let Some(path) = self.out.as_ref().or(self.html.as_ref()) {
            output::writable(path)?;
        }
        if let (None, [_, second, ..]) = (&self.html, &self.layouts[..]) {
            let message = format!("`{second}` is a second layout; several are drawn on a page, with `--html FILE`");
            return Err(LabError::usage(message));
        }
        let sheets = self.layouts.iter().map(|layout| self.sheet(layout)).collect::<Result<Vec<_>, _>>()?;
        if let Some(path) = &self.html {
            output::write(path, page(&self.record, &sheets).as_bytes())?;
        }
        match (&self.out, &self.html) {
            (None, None) => output::print(&sheets[0].svg),
            (Some(path), _) | (None, Some(path)) => {
                if self.out.is_some() {
                    output::write(path, sheets[0].svg.as_bytes())?;
                }
                let lines = sheets.iter().map(|sheet| format!("{}: {}\n", sheet.name, sheet.summary));
                output::print(&lines.chain([format!("written to {}\n", path.display())]).collect::<String>())
            }
        }
    }

    fn sheet(&self, layout: &str) -> Result<Sheet, LabError> {
        // What is dense beside sparse layouts is active all over.
        let sparse = |map: &TextMap| map.is_sparse();
        let several = self.layouts.len() > 1;
        let shape = self.shape.as_deref();
        let active = self
            .active
            .as_deref()
            .filter(|_| !several || TextMap::new(&self.record, layout, shape, None).as_ref().map_or(true, sparse));
        let map = TextMap::new(&self.record, layout, shape, active)?;
        let name = name(&map, layout);
        let drawing = Drawing { title: self.record.clone(), subtitle: name.clone(), lines: self.lines.into() };
        Ok(Sheet { svg: drawing.svg(&map), summary: summary(&map), name })
    }
}

/// The layout, what it is written out, and the shape.
fn name(map: &TextMap, layout: &str) -> String {
    let meaning = map.meaning().map_or(String::new(), |meaning| format!(" = {meaning}"));
    let shape: Vec<String> = map.shape().iter().map(usize::to_string).collect();
    format!("{layout}{meaning}, {} elements", shape.join(" x "))
}
