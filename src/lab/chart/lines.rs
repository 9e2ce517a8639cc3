//! Lines over two logarithmic axes: what changes by factors.

use plotters::element::{Circle, PathElement};
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, FontStyle, RGBColor};

use super::{Area, FAINT, INK, LINES, MARGIN, SIGN, fault, line, picture, write};
use crate::lab::errors::LabError;

/// A chart of lines, both axes logarithmic.
///
/// ```
/// use allotrope_lab::lab::chart::{Line, LineChart};
///
/// let line = Line { name: "private".into(), points: vec![[1e4, 20.0], [1e5, 18.0], [1e6, 30.0]] };
/// let chart = LineChart {
///     title: "Particle to grid".into(),
///     subtitle: "two threads".into(),
///     across: "particles".into(),
///     upwards: "nanoseconds a particle".into(),
///     lines: vec![line],
/// };
/// assert!(chart.svg().unwrap().starts_with("<svg"));
/// ```
#[derive(Clone, Debug)]
pub struct LineChart {
    /// Its headline.
    pub title: String,
    /// A line below the headline.
    pub subtitle: String,
    /// What grows to the right.
    pub across: String,
    /// What grows upwards, and in which unit.
    pub upwards: String,
    /// In the order of their colours.
    pub lines: Vec<Line>,
}

/// A line of a chart.
#[derive(Clone, Debug)]
pub struct Line {
    /// Right of its end.
    pub name: String,
    /// Its points from left to right, above zero on both axes.
    pub points: Vec<[f64; 2]>,
}

/// Pixels across and down.
const SIZE: [i32; 2] = [800, 480];
/// Pixels from the upper border to the plot.
const HEAD: i32 = 96;
/// Pixels from the plot to the lower border.
const FOOT: i32 = 64;
/// Pixels left of the plot.
const LEFT: i32 = 72;
/// Pixels from one name to the next, at least.
const APART: i32 = 17;

/// Colours that people who see few of them can tell apart (Okabe and Ito 2008, "Color universal design").
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(31, 41, 55),
];

/// From values to pixels.
#[derive(Clone, Copy)]
struct Scale {
    low: f64,
    high: f64,
    pixels: [i32; 2],
}

impl Scale {
    /// A scale on which all values lie, some room left at both ends.
    fn new(values: impl Iterator<Item = f64>, pixels: [i32; 2]) -> Self {
        let (low, high) = values.fold((f64::INFINITY, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (1.0, 1.0) };
        Self { low: low / 1.15, high: high * 1.15, pixels }
    }

    fn at(&self, value: f64) -> i32 {
        let share = (value / self.low).ln() / (self.high / self.low).ln();
        self.pixels[0] + (f64::from(self.pixels[1] - self.pixels[0]) * share).round() as i32
    }

    /// Round values: powers of ten, two and five times those where they are few, and more where they are fewer still.
    fn ticks(&self) -> Vec<f64> {
        let powers = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
        let scaled = |whole: f64, power: i32| {
            if power < 0 { whole / 10f64.powi(-power) } else { whole * 10f64.powi(power) }
        };
        let all = |factors: &[f64]| -> Vec<f64> {
            let ticks = powers.clone().flat_map(|power| factors.iter().map(move |&factor| scaled(factor, power)));
            ticks.filter(|tick| (self.low..=self.high).contains(tick)).collect()
        };
        let tens = all(&[1.0]);
        let some = all(&[1.0, 2.0, 5.0]);
        match (tens.len(), some.len()) {
            (3.., _) => tens,
            (_, 2..) => some,
            _ => all(&[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]),
        }
    }
}

impl LineChart {
    /// The text of an SVG file.
    ///
    /// # Errors
    /// If a value is not finite or not above zero, or the picture cannot be drawn.
    pub fn svg(&self) -> Result<String, LabError> {
        for Line { name, points } in &self.lines {
            if let Some(wrong) = points.iter().flatten().find(|value| !value.is_finite() || **value <= 0.0) {
                let message =
                    format!("a chart of factors cannot show `{name}` at {wrong}; values are finite and above zero");
                return Err(LabError::failure(message));
            }
        }
        picture(SIZE, |area| self.draw(area))
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), LabError> {
        let signs = self.lines.iter().map(|line| line.name.chars().count()).max().unwrap_or(0);
        let names = (13.0 * SIGN * signs as f64).ceil() as i32 + 16;
        let right = (SIZE[0] - MARGIN - names).max(SIZE[0] / 2);
        let (top, bottom) = (HEAD, SIZE[1] - FOOT);
        let values = |axis: usize| self.lines.iter().flat_map(move |line| line.points.iter().map(move |p| p[axis]));
        let (x, y) = (Scale::new(values(0), [LEFT, right]), Scale::new(values(1), [bottom, top]));

        write(area, &self.title, (MARGIN, MARGIN), 20, INK, HPos::Left, FontStyle::Bold)?;
        write(area, &self.subtitle, (MARGIN, MARGIN + 28), 12, FAINT, HPos::Left, FontStyle::Normal)?;
        write(area, &self.upwards, (MARGIN, top - 20), 12, FAINT, HPos::Left, FontStyle::Normal)?;
        for tick in x.ticks() {
            line(area, [(x.at(tick), top), (x.at(tick), bottom)], LINES)?;
            write(area, &text(tick), (x.at(tick), bottom + 8), 12, FAINT, HPos::Center, FontStyle::Normal)?;
        }
        for tick in y.ticks() {
            line(area, [(LEFT, y.at(tick)), (right, y.at(tick))], LINES)?;
            write(area, &text(tick), (LEFT - 8, y.at(tick) - 6), 12, FAINT, HPos::Right, FontStyle::Normal)?;
        }
        write(area, &self.across, (LEFT, bottom + 30), 12, FAINT, HPos::Left, FontStyle::Normal)?;
        line(area, [(LEFT, bottom), (right, bottom)], FAINT)?;

        for (n, Line { points, .. }) in self.lines.iter().enumerate() {
            let colour = COLOURS[n % COLOURS.len()];
            let places: Vec<(i32, i32)> = points.iter().map(|p| (x.at(p[0]), y.at(p[1]))).collect();
            area.draw(&PathElement::new(places.clone(), colour.stroke_width(2))).map_err(fault)?;
            for place in places {
                area.draw(&Circle::new(place, 3, colour.filled())).map_err(fault)?;
            }
        }
        let ends = self.lines.iter().enumerate().filter_map(|(n, line)| Some((n, y.at(line.points.last()?[1]))));
        for (n, place) in spread(ends.collect()) {
            let colour = COLOURS[n % COLOURS.len()];
            write(area, &self.lines[n].name, (right + 10, place - 6), 13, colour, HPos::Left, FontStyle::Normal)?;
        }
        Ok(())
    }
}

/// Names moved downwards until none lies on another, in the order of their lines' ends.
fn spread(mut names: Vec<(usize, i32)>) -> Vec<(usize, i32)> {
    names.sort_by_key(|&(_, place)| place);
    let mut free = i32::MIN;
    for (_, place) in &mut names {
        *place = (*place).max(free);
        free = *place + APART;
    }
    // The last ones may have been pushed out of the picture: then all above give way.
    let mut floor = SIZE[1] - FOOT;
    for (_, place) in names.iter_mut().rev() {
        *place = (*place).min(floor);
        floor = *place - APART;
    }
    names
}

/// A round number, in powers of ten where it is long.
fn text(tick: f64) -> String {
    if (1e-3..1e5).contains(&tick) { tick.to_string() } else { format!("{tick:e}") }
}

#[cfg(test)]
mod tests {
    use super::super::tests::numbers;
    use super::*;

    fn chart(lines: Vec<Line>) -> LineChart {
        let [title, subtitle, across, upwards] = ["A & B", "here", "particles", "ns"].map(String::from);
        LineChart { title, subtitle, across, upwards, lines }
    }

    fn named(name: &str, points: &[[f64; 2]]) -> Line {
        Line { name: name.into(), points: points.to_vec() }
    }

    #[test]
    fn equal_factors_are_equal_distances() {
        let svg = chart(vec![named("a", &[[1e4, 1.0], [1e5, 10.0], [1e6, 100.0]])]).svg().unwrap();
        let (xs, ys) = (numbers(&svg, "<circle", "cx"), numbers(&svg, "<circle", "cy"));
        assert_eq!((xs.len(), ys.len()), (3, 3), "{svg}");
        assert!((xs[1] - xs[0] - (xs[2] - xs[1])).abs() <= 1.0 && xs[0] < xs[1], "{xs:?}");
        assert!((ys[1] - ys[0] - (ys[2] - ys[1])).abs() <= 1.0 && ys[0] > ys[1], "{ys:?}");
        assert!(svg.contains("\n1e6\n") && svg.contains("\n10000\n"), "{svg}");
    }

    #[test]
    fn a_narrow_scale_has_ticks_too() {
        let scale = Scale::new([210.0, 290.0].into_iter(), [0, 100]);
        assert_eq!(scale.ticks(), [200.0, 250.0, 300.0]);
        assert_eq!(Scale::new([1.0, 30.0].into_iter(), [0, 100]).ticks(), [1.0, 2.0, 5.0, 10.0, 20.0]);
        assert_eq!(Scale::new([1.0, 300.0].into_iter(), [0, 100]).ticks(), [1.0, 10.0, 100.0]);
    }

    #[test]
    fn names_do_not_lie_on_one_another() {
        let lines: Vec<Line> =
            (0..9).map(|n| named(&format!("line {n}"), &[[1.0, 5.0], [2.0, 5.0 + 1e-3 * f64::from(n)]])).collect();
        let svg = chart(lines).svg().unwrap();
        assert!((0..9).all(|n| svg.contains(&format!("\nline {n}\n"))), "{svg}");
        let places = spread((0..9).map(|n| (n, 430)).collect());
        assert!(places.windows(2).all(|pair| pair[1].1 - pair[0].1 >= APART), "{places:?}");
        assert!(places.iter().all(|(_, place)| (0..SIZE[1]).contains(place)), "{places:?}");
    }

    #[test]
    fn nothing_lies_outside() {
        let long =
            named("a name that is rather long, and longer than there is room for here", &[[1.0, 1e-9], [2.0, 1e9]]);
        for lines in [vec![long], Vec::new(), vec![named("nothing", &[])], vec![named("one", &[[3.0, 3.0]])]] {
            let svg = chart(lines).svg().unwrap();
            let xs = [numbers(&svg, "<text", "x"), numbers(&svg, "<circle", "cx")].concat();
            assert!(xs.iter().all(|x| (0.0..=f64::from(SIZE[0])).contains(x)), "{svg}");
            let ys = [numbers(&svg, "<text", "y"), numbers(&svg, "<circle", "cy")].concat();
            assert!(ys.iter().all(|y| (0.0..=f64::from(SIZE[1])).contains(y)), "{svg}");
        }
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        let message = chart(vec![named("a", &[[1.0, 0.0]])]).svg().unwrap_err().to_string();
        assert_eq!(message, "a chart of factors cannot show `a` at 0; values are finite and above zero");
    }
}
