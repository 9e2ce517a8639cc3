//! Charts as SVG pictures, which browsers, editors and papers show.

mod bars;
mod lines;

use std::fmt::Display;

use plotters::coord::Shift;
use plotters::element::{PathElement, Text};
use plotters::prelude::{DrawingArea, IntoDrawingArea, RGBColor, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, IntoFont};

pub use self::bars::{Bar, BarChart};
pub use self::lines::{Line, LineChart};
use super::errors::LabError;

/// Pixels of the border.
const MARGIN: i32 = 24;
/// Pixels of a sign of text of that height, at most on average: who draws the picture chooses the font.
const SIGN: f64 = 0.6;

const PAPER: RGBColor = RGBColor(255, 255, 255);
const INK: RGBColor = RGBColor(31, 41, 55);
const FAINT: RGBColor = RGBColor(107, 114, 128);
const LINES: RGBColor = RGBColor(229, 231, 235);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The text of an SVG file of so many pixels across and down.
fn picture(size: [i32; 2], draw: impl FnOnce(&Area<'_>) -> Result<(), LabError>) -> Result<String, LabError> {
    let mut svg = String::new();
    {
        let [width, height] = size.map(|pixels| pixels as u32);
        let area = SVGBackend::with_string(&mut svg, (width, height)).into_drawing_area();
        area.fill(&PAPER).map_err(fault)?;
        draw(&area)?;
        area.present().map_err(fault)?;
    }
    Ok(svg)
}

fn line(area: &Area<'_>, ends: [(i32, i32); 2], colour: RGBColor) -> Result<(), LabError> {
    area.draw(&PathElement::new(ends.to_vec(), colour.stroke_width(1))).map_err(fault)
}

/// A line of text, `size` pixels high, whose upper end is at `place`.
fn write(
    area: &Area<'_>,
    text: &str,
    place: (i32, i32),
    size: i32,
    colour: RGBColor,
    side: HPos,
    style: FontStyle,
) -> Result<(), LabError> {
    // What SVG calls a font's size is 1.24 times less than what `plotters` does.
    let font = ("sans-serif", 1.24 * f64::from(size)).into_font().style(style);
    let style = font.color(&colour).pos(Pos::new(side, VPos::Top));
    area.draw(&Text::new(text, place, style)).map_err(fault)
}

fn fault(error: impl Display) -> LabError {
    LabError::failure(format!("a chart cannot be drawn: {error}"))
}

#[cfg(test)]
mod tests {
    /// The number of an attribute in each element that has it and begins so.
    pub(super) fn numbers(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
        let elements = svg.lines().filter(|line| line.starts_with(element));
        let key = format!(" {attribute}=\"");
        elements.filter_map(|line| line.split_once(&key)?.1.split('"').next()?.parse().ok()).collect()
    }
}
