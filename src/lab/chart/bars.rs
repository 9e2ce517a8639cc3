//! Bars.

use plotters::element::Rectangle;
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, FontStyle, RGBColor};

use super::{Area, FAINT, INK, LINES, MARGIN, SIGN, fault, line, picture, write};
use crate::lab::errors::LabError;

/// A chart of horizontal bars from zero on.
#[derive(Clone, Debug)]
pub struct BarChart {
    /// Its headline.
    pub title: String,
    /// A line below the headline.
    pub subtitle: String,
    /// What bars measure, and in which unit.
    pub axis: String,
    /// From the top.
    pub bars: Vec<Bar>,
}

/// A bar of a chart.
#[derive(Clone, Debug)]
pub struct Bar {
    /// Left of the bar.
    pub name: String,
    /// Its length, on the axis.
    pub value: f64,
    /// From where to where the whisker reaches, on the axis.
    pub range: [f64; 2],
    /// The value in words, right of the bar.
    pub label: String,
    /// What is to be said beside, in a column of its own.
    pub note: String,
    /// Whether it has the colour that stands out.
    pub accented: bool,
}

/// Pixels across.
const WIDTH: i32 = 800;
/// Pixels from the upper border to the first bar's row: headline and subtitle.
const HEAD: i32 = 84;
/// Pixels below the last bar's row: the axis.
const FOOT: i32 = 64;
/// Pixels from bar to bar.
const ROW: i32 = 36;
/// Pixels of a bar's height.
const THICKNESS: i32 = 20;
/// Half the pixels of a whisker's ends.
const CAP: i32 = 4;
/// Pixels for label and note.
const RIGHT: i32 = 160;

const BARS: RGBColor = RGBColor(147, 176, 214);
const ACCENT: RGBColor = RGBColor(29, 99, 184);

impl BarChart {
    /// The text of an SVG file.
    ///
    /// # Errors
    /// If a value is not finite or below zero, or the picture cannot be drawn.
    pub fn svg(&self) -> Result<String, LabError> {
        for Bar { name, value, range, .. } in &self.bars {
            if let Some(wrong) = [*value, range[0], range[1]].iter().find(|value| !value.is_finite() || **value < 0.0) {
                let message =
                    format!("a bar chart cannot show `{name}` at {wrong}; values are finite and not negative");
                return Err(LabError::failure(message));
            }
        }
        let height = HEAD + ROW * self.bars.len() as i32 + FOOT;
        picture([WIDTH, height], |area| self.draw(area))
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), LabError> {
        let signs = self.bars.iter().map(|bar| bar.name.chars().count()).max().unwrap_or(0);
        let left = (MARGIN + 12 + (14.0 * SIGN * signs as f64).ceil() as i32).min(WIDTH / 2);
        let longest = self.bars.iter().flat_map(|bar| [bar.value, bar.range[1]]).fold(0.0, f64::max);
        let longest = if longest > 0.0 { longest } else { 1.0 };
        let at = |value: f64| left + (f64::from(WIDTH - MARGIN - RIGHT - left) * value / longest).round() as i32;
        let end = HEAD + ROW * self.bars.len() as i32;

        write(area, &self.title, (MARGIN, MARGIN), 20, INK, HPos::Left, FontStyle::Bold)?;
        write(area, &self.subtitle, (MARGIN, MARGIN + 28), 12, FAINT, HPos::Left, FontStyle::Normal)?;
        for tick in ticks(longest) {
            line(area, [(at(tick), HEAD), (at(tick), end)], LINES)?;
            write(area, &tick.to_string(), (at(tick), end + 8), 12, FAINT, HPos::Center, FontStyle::Normal)?;
        }
        write(area, &self.axis, (left, end + 30), 12, FAINT, HPos::Left, FontStyle::Normal)?;
        for (n, bar) in self.bars.iter().enumerate() {
            let middle = HEAD + ROW * n as i32 + ROW / 2;
            let (top, bottom) = (middle - THICKNESS / 2, middle + THICKNESS / 2);
            let (colour, style) = if bar.accented { (ACCENT, FontStyle::Bold) } else { (BARS, FontStyle::Normal) };
            area.draw(&Rectangle::new([(left, top), (at(bar.value), bottom)], colour.filled())).map_err(fault)?;
            let [from, to] = bar.range.map(at);
            line(area, [(from, middle), (to, middle)], INK)?;
            for cap in [from, to] {
                line(area, [(cap, middle - CAP), (cap, middle + CAP)], INK)?;
            }
            let text = middle - 5;
            write(area, &bar.name, (left - 10, text), 14, INK, HPos::Right, style)?;
            write(area, &bar.label, (at(bar.value).max(to) + 10, text), 14, INK, HPos::Left, style)?;
            write(area, &bar.note, (WIDTH - MARGIN, text), 14, FAINT, HPos::Right, style)?;
        }
        line(area, [(left, HEAD), (left, end)], FAINT)
    }
}

/// Round values from zero to `longest`: multiples of 1, 2 or 5 times a power of ten, some four to nine. They are printed
/// as they are, so each is a quotient or product of whole numbers.
fn ticks(longest: f64) -> Vec<f64> {
    let power = (longest / 4.0).log10().floor() as i32;
    let scaled = |whole: f64| if power < 0 { whole / 10f64.powi(-power) } else { whole * 10f64.powi(power) };
    let step = [5.0, 2.0, 1.0].into_iter().find(|&step| scaled(4.0 * step) <= longest).unwrap_or(1.0);
    (0..).map(|n| scaled(step * f64::from(n))).take_while(|&tick| tick <= longest).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::numbers;
    use super::*;

    fn bar(name: &str, value: f64, range: [f64; 2]) -> Bar {
        let label = format!("{value} ms");
        Bar { name: name.into(), value, range, label, note: "1.00 x".into(), accented: value == 1.5 }
    }

    fn chart(bars: Vec<Bar>) -> BarChart {
        BarChart { title: "A & B < C".into(), subtitle: "here".into(), axis: "ms".into(), bars }
    }

    #[test]
    fn lengths_are_as_values() {
        let svg = chart(vec![bar("aos", 3.0, [2.5, 4.0]), bar("soa", 1.5, [1.5, 1.5])]).svg().unwrap();
        // The first is the paper.
        let widths = numbers(&svg, "<rect", "width");
        assert_eq!(widths.len(), 3, "{svg}");
        assert!((widths[1] / widths[2] - 2.0).abs() < 0.02, "{widths:?}");
        assert_eq!(numbers(&svg, "<rect", "height")[1..], [20.0, 20.0]);
        assert!(svg.contains("\nA &amp; B &lt; C\n") && svg.contains("\n3 ms\n"), "{svg}");
        // The accented one alone has the colour that stands out.
        assert_eq!(svg.matches("#1D63B8").count(), 1, "{svg}");
    }

    #[test]
    fn nothing_lies_outside() {
        let bars = vec![bar("a name that is rather long, and longer than there is room", 1e-4, [0.0, 1e-3])];
        for bars in [bars, Vec::new(), vec![bar("nothing", 0.0, [0.0, 0.0])]] {
            let svg = chart(bars).svg().unwrap();
            let xs = [numbers(&svg, "<text", "x"), numbers(&svg, "<rect", "x")].concat();
            assert!(xs.iter().all(|x| (0.0..=f64::from(WIDTH)).contains(x)), "{svg}");
        }
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        let message = chart(vec![bar("aos", f64::NAN, [0.0, 1.0])]).svg().unwrap_err().to_string();
        assert_eq!(message, "a bar chart cannot show `aos` at NaN; values are finite and not negative");
        assert!(chart(vec![bar("aos", 1.0, [-1.0, 1.0])]).svg().is_err());
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(1.0), [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        assert_eq!(ticks(4.3), [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(ticks(29.0), [0.0, 5.0, 10.0, 15.0, 20.0, 25.0]);
        assert_eq!(ticks(0.07), [0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07]);
    }
}
