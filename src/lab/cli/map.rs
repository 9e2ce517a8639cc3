//! `allotrope map`.

use std::path::PathBuf;

use clap::Args;

use super::values;
use crate::lab::errors::LabError;
use crate::lab::map::{Drawing, Mapped, TextMap, summary};
use crate::lab::output;

/// What is asked of `allotrope map`.
#[derive(Args, Debug)]
pub struct MapArguments {
    /// The members of a record and their types, `x: Vec2, m: f32`, or one type
    #[arg(value_name = "RECORD")]
    record: String,
    /// A layout, `dense(ij).dense(ij, 4).aos` or `Blocked<4>`
    #[arg(value_name = "LAYOUT")]
    layout: String,
    /// Elements along each axis [default: few]
    #[arg(long, value_name = "N,M", value_parser = values::shape)]
    shape: Option<Shape>,
    /// What is active in a sparse layout: all, none, diagonal, disc, random:PERCENT, or boxes of indices [default: diagonal]
    #[arg(long, value_name = "WHAT", allow_hyphen_values = true)]
    active: Option<String>,
    /// The most lines of 64 bytes that are drawn
    #[arg(long, value_name = "N", default_value = "24", value_parser = clap::value_parser!(u16).range(1..=2000))]
    lines: u16,
    /// Writes the picture to a file, and what it amounts to on the screen [default: the picture itself is printed]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Extents, a number an axis.
pub(super) type Shape = std::sync::Arc<[usize]>;

impl MapArguments {
    pub(super) fn execute(self) -> Result<(), LabError> {
        let Self { record, layout, shape, active, lines, out } = self;
        if let Some(path) = &out {
            output::writable(path)?;
        }
        let map = TextMap::new(&record, &layout, shape.as_deref(), active.as_deref())?;
        let svg = Drawing { title: record, subtitle: subtitle(&map, &layout), lines: lines.into() }.svg(&map);
        match out {
            None => output::print(&svg),
            Some(path) => {
                output::write(&path, svg.as_bytes())?;
                output::print(&format!("{}\n{}: {}\n", subtitle(&map, &layout), path.display(), summary(&map)))
            }
        }
    }
}

/// The layout, what it is written out, and the shape.
fn subtitle(map: &TextMap, layout: &str) -> String {
    let meaning = map.meaning().map_or(String::new(), |meaning| format!(" = {meaning}"));
    let shape: Vec<String> = map.shape().iter().map(usize::to_string).collect();
    format!("{layout}{meaning}, {} elements", shape.join(" x "))
}
