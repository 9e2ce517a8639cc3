//! Pictures of how often each cache line of a field was touched.

use std::path::Path;

use allotrope::probe::{Heat, Recording};

use crate::lab::errors::LabError;
use crate::lab::output;
use crate::lab::render::Picture;

/// Lines of a row: a page of 4 KiB.
const ROW: usize = 64;

/// The most rows of a picture: of larger fields each square stands for several lines.
const ROWS: usize = 160;

/// Pixels of a square.
const SQUARE: usize = 8;

/// Cold to hot, in sRGB; what was not touched has a colour of its own.
const COLOURS: [[u8; 3]; 5] = [[36, 52, 110], [52, 120, 160], [96, 180, 132], [232, 196, 80], [200, 52, 40]];
const UNTOUCHED: [u8; 3] = [232, 232, 236];

/// Writes `heat-LAYOUT-FIELD.png` for each field.
pub(super) fn write(folder: &Path, layout: &str, recording: &Recording) -> Result<(), LabError> {
    for heat in &recording.heat {
        let name = format!("heat-{}-{}.png", layout.replace(['/', ' '], "-"), heat.field);
        output::write(&folder.join(name), &picture(heat).png()?)?;
    }
    Ok(())
}

/// A square a cache line, 64 to a row, coloured by the logarithm of its touches.
pub(super) fn picture(heat: &Heat) -> Picture {
    let together = heat.touches.len().div_ceil(ROW * ROWS).max(1);
    let squares: Vec<u32> =
        heat.touches.chunks(together).map(|lines| lines.iter().copied().max().unwrap_or(0)).collect();
    let hottest = squares.iter().copied().max().unwrap_or(0).max(1);
    let (width, height) = (ROW * SQUARE, squares.len().div_ceil(ROW).max(1) * SQUARE);
    let colour = |x: usize, y: usize| {
        let touches = squares.get(y / SQUARE * ROW + x / SQUARE).copied();
        // A line between squares, so that they can be counted.
        match touches {
            None => [255; 3],
            Some(_) if x.is_multiple_of(SQUARE) || y.is_multiple_of(SQUARE) => [255; 3],
            Some(touches) => tone(touches, hottest),
        }
    };
    let rgb = (0..height).flat_map(|y| (0..width).flat_map(move |x| colour(x, y))).collect();
    Picture { width, height, rgb }
}

/// The colour of so many touches.
fn tone(touches: u32, hottest: u32) -> [u8; 3] {
    if touches == 0 {
        return UNTOUCHED;
    }
    let place = f64::from(touches).ln() / f64::from(hottest).ln().max(f64::MIN_POSITIVE) * (COLOURS.len() - 1) as f64;
    let below = (place as usize).min(COLOURS.len() - 2);
    let part = (place - below as f64).clamp(0.0, 1.0);
    let blend = |c: usize| {
        let [from, to] = [COLOURS[below][c], COLOURS[below + 1][c]].map(f64::from);
        (from + (to - from) * part).round() as u8
    };
    [blend(0), blend(1), blend(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_shows_its_line() {
        let mut touches = vec![1; 70];
        (touches[1], touches[69]) = (0, 1000);
        let picture = picture(&Heat { field: "grid", touches });
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
        let picture = picture(&Heat { field: "grid", touches });
        assert_eq!(picture.height, ROWS * SQUARE);
        let third = 3 * (SQUARE / 2 * picture.width + 2 * SQUARE + SQUARE / 2);
        assert_eq!(picture.rgb[third..][..3], COLOURS[4], "line 7 of three together");
    }
}
