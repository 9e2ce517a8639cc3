//! How often each cache line of a field was touched: as numbers, and as pictures.

use std::fmt::Write;
use std::path::Path;

use allotrope::probe::{Heat, LINE};
use serde::{Deserialize, Serialize};

use super::Layout;
use crate::lab::errors::LabError;
use crate::lab::map::escaped;
use crate::lab::output;
use crate::lab::render::Picture;
use crate::lab::table::four_digits;

/// Lines of a row: a page of 4 KiB.
const ROW: usize = 64;

/// The most rows: of larger fields each square stands for several lines.
const ROWS: usize = 160;

/// Pixels of a square in a PNG file.
const SQUARE: usize = 8;

/// Units of a square in an SVG picture.
const UNIT: usize = 8;

/// Units to the left of the squares, where the bytes are told, and above and below them.
const LEFT: usize = 64;
const ABOVE: usize = 44;
const BELOW: usize = 46;

/// Cold to hot, in sRGB; what was not touched has a colour of its own.
const COLOURS: [[u8; 3]; 5] = [[36, 52, 110], [52, 120, 160], [96, 180, 132], [232, 196, 80], [200, 52, 40]];
const UNTOUCHED: [u8; 3] = [232, 232, 236];

/// Tones of an SVG picture, in which neighbours of a tone are one shape.
const TONES: usize = 16;

/// How often the cache lines of a field were touched.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct HeatMap {
    /// The field, as the kernels call it.
    pub field: String,
    /// Its cache lines.
    pub lines: usize,
    /// Neighbouring lines that are told together, by the hottest of them.
    pub together: usize,
    /// How often each was touched, in the order of memory.
    pub touches: Vec<u32>,
}

impl HeatMap {
    /// The map of what was recorded of a field.
    pub fn new(heat: &Heat) -> Self {
        let whole =
            Self { field: heat.field.into(), lines: heat.touches.len(), together: 1, touches: heat.touches.clone() };
        whole.coarser(ROWS)
    }

    /// The same in at most so many rows.
    pub fn coarser(&self, rows: usize) -> Self {
        let factor = self.touches.len().div_ceil(ROW * rows.max(1)).max(1);
        let hottest = |lines: &[u32]| lines.iter().copied().max().unwrap_or(0);
        Self {
            field: self.field.clone(),
            lines: self.lines,
            together: self.together * factor,
            touches: self.touches.chunks(factor).map(hottest).collect(),
        }
    }

    fn hottest(&self) -> u32 {
        self.touches.iter().copied().max().unwrap_or(0)
    }

    /// A square a cache line, 64 to a row, coloured by the logarithm of its touches.
    pub fn picture(&self) -> Picture {
        let hottest = self.hottest();
        let (width, height) = (ROW * SQUARE, self.touches.len().div_ceil(ROW).max(1) * SQUARE);
        let colour = |x: usize, y: usize| {
            // A line between squares, so that they can be counted.
            match self.touches.get(y / SQUARE * ROW + x / SQUARE) {
                None => [255; 3],
                Some(_) if x.is_multiple_of(SQUARE) || y.is_multiple_of(SQUARE) => [255; 3],
                Some(&touches) => tone(warmth(touches, hottest)),
            }
        };
        let rgb = (0..height).flat_map(|y| (0..width).flat_map(move |x| colour(x, y))).collect();
        Picture { width, height, rgb }
    }

    /// The same as the text of an SVG file, with the bytes at which rows begin, and what the colours say.
    pub fn svg(&self, title: &str) -> String {
        let (hottest, rows) = (self.hottest(), self.touches.len().div_ceil(ROW).max(1));
        let (width, height) = (LEFT + ROW * UNIT + UNIT, ABOVE + rows * UNIT + BELOW);
        let squares = match self.together {
            1 => "a square is a cache line of 64 bytes".to_string(),
            many => format!("a square is {many} cache lines of 64 bytes, and shows the hottest"),
        };
        let untouched = self.touches.iter().filter(|&&touches| touches == 0).count();
        let about = format!("{} bytes; {squares}", self.lines * LINE);
        let mut body = String::new();
        text(&mut body, [LEFT, 18], 15, "start", title);
        text(&mut body, [LEFT, 35], 11, "start", &about);
        for (tone, shape) in self.shapes(hottest).iter().enumerate().filter(|(_, shape)| !shape.is_empty()) {
            let colour = if tone == 0 { hex(UNTOUCHED) } else { hex(self::tone(Some(tone_warmth(tone)))) };
            let _ = writeln!(body, r#"<path d="{shape}" fill="{colour}"/>"#);
        }
        // Rows are told where there is room for the numbers.
        for row in (0..rows).step_by(rows.div_ceil(24).max(2)) {
            let bytes = row * ROW * self.together * LINE;
            text(&mut body, [LEFT - 6, ABOVE + row * UNIT + UNIT], 9, "end", &size(bytes));
        }
        self.legend(&mut body, [LEFT, ABOVE + rows * UNIT + 14], hottest);
        let title = escaped(title);
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" style="max-width:100%;height:auto" role="img" font-family="'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif" fill="#111827">
<title>{title}</title>
<desc>{about}; the hottest was touched {hottest} times, {untouched} squares were not touched</desc>
<rect width="{width}" height="{height}" fill="#ffffff"/>
{body}</svg>
"##
        )
    }

    /// For each tone the squares that have it, neighbours in a row as one rectangle.
    fn shapes(&self, hottest: u32) -> [String; TONES + 1] {
        let mut shapes = [const { String::new() }; TONES + 1];
        for (row, squares) in self.touches.chunks(ROW).enumerate() {
            let mut first = 0;
            for same in squares.chunk_by(|&a, &b| step(a, hottest) == step(b, hottest)) {
                let (x, y, run) = (LEFT + first * UNIT, ABOVE + row * UNIT, same.len() * UNIT);
                let _ = write!(shapes[step(same[0], hottest)], "M{x} {y}h{run}v{UNIT}h-{run}z");
                first += same.len();
            }
        }
        shapes
    }

    /// The tones with what they stand for.
    fn legend(&self, body: &mut String, [x, y]: [usize; 2], hottest: u32) {
        let _ = writeln!(body, r#"<rect x="{x}" y="{y}" width="12" height="10" fill="{}"/>"#, hex(UNTOUCHED));
        text(body, [x + 17, y + 9], 10, "start", "not touched");
        if hottest == 0 {
            return;
        }
        let (first, width) = (x + 110, 12);
        for tone in 1..=TONES {
            let (at, colour) = (first + (tone - 1) * width, hex(self::tone(Some(tone_warmth(tone)))));
            let _ = writeln!(body, r#"<rect x="{at}" y="{y}" width="{width}" height="10" fill="{colour}"/>"#);
        }
        let end = first + TONES * width;
        text(body, [first, y + 22], 10, "start", "once");
        text(body, [end, y + 22], 10, "end", &format!("{hottest} times, by the logarithm"));
    }
}

/// How warm so many touches are, from 0 to 1 by their logarithm; nothing if there are none.
fn warmth(touches: u32, hottest: u32) -> Option<f64> {
    let all = f64::from(hottest).ln();
    (touches > 0).then(|| if all > 0.0 { f64::from(touches).ln() / all } else { 1.0 })
}

/// The number of the tone of so many touches, from 1 on; 0 for none.
fn step(touches: u32, hottest: u32) -> usize {
    warmth(touches, hottest).map_or(0, |warmth| 1 + (warmth * (TONES - 1) as f64).round() as usize)
}

fn tone_warmth(step: usize) -> f64 {
    (step - 1) as f64 / (TONES - 1) as f64
}

/// The colour of a warmth.
fn tone(warmth: Option<f64>) -> [u8; 3] {
    let Some(warmth) = warmth else { return UNTOUCHED };
    let place = warmth * (COLOURS.len() - 1) as f64;
    let below = (place as usize).min(COLOURS.len() - 2);
    let part = (place - below as f64).clamp(0.0, 1.0);
    let blend = |c: usize| {
        let [from, to] = [COLOURS[below][c], COLOURS[below + 1][c]].map(f64::from);
        (from + (to - from) * part).round() as u8
    };
    [blend(0), blend(1), blend(2)]
}

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn text(body: &mut String, [x, y]: [usize; 2], size: usize, anchor: &str, words: &str) {
    let words = escaped(words);
    let _ = writeln!(body, r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}">{words}</text>"#);
}

/// Bytes in the unit that makes them short.
fn size(bytes: usize) -> String {
    match bytes {
        0..1024 => format!("{bytes}"),
        1024..1_048_576 => format!("{} KiB", bytes >> 10),
        _ => format!("{} MiB", four_digits(bytes as f64 / f64::from(1 << 20))),
    }
}

/// Writes `heat-LAYOUT-FIELD.png` and `.svg` for each field.
pub(super) fn write(folder: &Path, counted: &Layout) -> Result<(), LabError> {
    for map in &counted.heat {
        let name = format!("heat-{}-{}", counted.layout.replace(['/', ' '], "-"), map.field);
        output::write(&folder.join(format!("{name}.png")), &map.picture().png()?)?;
        let title = format!("{} in {}: how often each line was touched", map.field, counted.layout);
        output::write(&folder.join(format!("{name}.svg")), map.svg(&title).as_bytes())?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(touches: Vec<u32>) -> HeatMap {
        HeatMap::new(&Heat { field: "grid", touches })
    }

    #[test]
    fn a_square_shows_its_line() {
        let mut touches = vec![1; 70];
        (touches[1], touches[69]) = (0, 1000);
        let picture = map(touches).picture();
        assert_eq!((picture.width, picture.height), (64 * SQUARE, 2 * SQUARE));
        let at = |square: usize| {
            let (x, y) = (square % ROW * SQUARE + SQUARE / 2, square / ROW * SQUARE + SQUARE / 2);
            &picture.rgb[3 * (y * picture.width + x)..][..3]
        };
        assert_eq!((at(0), at(1), at(69), at(70)), (&COLOURS[0][..], &UNTOUCHED[..], &COLOURS[4][..], &[255; 3][..]));
    }

    #[test]
    fn large_fields_are_shown_by_their_hottest_lines() {
        let mut touches = vec![0; 3 * ROW * ROWS];
        touches[7] = 5;
        let map = map(touches);
        assert_eq!((map.lines, map.together, map.touches.len()), (3 * ROW * ROWS, 3, ROW * ROWS));
        assert_eq!((map.touches[2], map.touches.iter().sum::<u32>()), (5, 5), "line 7 of three together");
        let coarse = map.coarser(10);
        assert_eq!((coarse.together, coarse.touches.len(), coarse.touches[0]), (48, 640, 5));
        assert_eq!(map.coarser(ROWS), map);
    }

    #[test]
    fn an_svg_map_joins_neighbours_of_a_tone() {
        let mut touches = vec![3; 70];
        (touches[1], touches[69]) = (0, 1000);
        let svg = map(touches).svg("grid in aos & soa");
        assert!(svg.contains("<title>grid in aos &amp; soa</title>"), "{svg}");
        let untouched = format!("<path d=\"M{} {ABOVE}h8v8h-8z\" fill=\"#e8e8ec\"/>", LEFT + 8);
        assert!(svg.contains(&untouched), "{svg}");
        // What was touched alike: the first square, the rest of the first row, and all but the last of the second.
        let alike =
            format!("d=\"M{LEFT} {ABOVE}h8v8h-8zM{} {ABOVE}h496v8h-496zM{LEFT} {}h40v8h-40z\"", LEFT + 16, ABOVE + 8);
        assert!(svg.contains(&alike), "{svg}");
        assert!(svg.contains("the hottest was touched 1000 times, 1 squares were not touched"), "{svg}");
    }

    #[test]
    fn what_was_touched_once_alone_is_warm_too() {
        assert_eq!((warmth(0, 1), warmth(1, 1), warmth(1, 9), warmth(9, 9)), (None, Some(1.0), Some(0.0), Some(1.0)));
        assert_eq!([0, 1, 9].map(|touches| step(touches, 9)), [0, 1, TONES]);
        assert_eq!([100, 4096, 3 << 20].map(size), ["100", "4 KiB", "3.000 MiB"]);
    }
}
