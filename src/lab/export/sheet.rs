//! A contact sheet: some pictures of a run in one, halved, each with its step and time.

use super::text;
use crate::lab::errors::LabError;
use crate::lab::render::Picture;

/// Pictures on a sheet, at most.
pub const MOST: usize = 12;

/// Pixels between pictures.
const GAP: usize = 8;

/// Pixels above a picture for its label, whose dots are two pixels wide.
const LABEL: usize = 2 * text::HEIGHT + 12;

const BACKGROUND: [u8; 3] = [0x05, 0x07, 0x0d];
const INK: [u8; 3] = [0xc8, 0xd2, 0xe4];

/// The pictures that a sheet of a run of `frames` pictures shows: all of them, or [`MOST`], evenly picked, the first
/// and the last among them.
pub fn picks(frames: usize) -> Vec<usize> {
    let shown = frames.min(MOST);
    (0..shown).map(|n| if shown < 2 { n } else { (n * (frames - 1) + (shown - 1) / 2) / (shown - 1) }).collect()
}

/// What a picture is labelled with: `step 120  0.0240 s`.
pub fn label(step: u64, time: f64) -> String {
    format!("step {step}  {time:.4} s")
}

/// A contact sheet, picture by picture: no more of them are kept than it shows.
#[derive(Clone, Debug)]
pub struct Sheet {
    picks: Vec<usize>,
    kept: Vec<(Picture, String)>,
}

impl Sheet {
    /// The sheet of a run that is to have `frames` pictures.
    pub fn new(frames: usize) -> Self {
        Self { picks: picks(frames), kept: Vec::new() }
    }

    /// Whether the picture of that number (from zero) is shown.
    pub fn wants(&self, number: usize) -> bool {
        self.picks.contains(&number)
    }

    /// Adds the picture of that number with its label, if it is shown.
    pub fn add(&mut self, number: usize, picture: &Picture, label: &str) {
        if self.wants(number) {
            self.kept.push((picture.halved(), label.to_string()));
        }
    }

    /// The sheet of what was added so far; of nothing, if nothing was.
    pub fn picture(&self) -> Option<Picture> {
        let wide = self.kept.iter().map(|(picture, _)| picture.width).max()?;
        let high = self.kept.iter().map(|(picture, _)| picture.height).max()?;
        // Four by three for a full sheet, and about as wide for others.
        let columns = (1..).find(|columns| columns * columns * 3 >= self.kept.len() * 4).unwrap_or(1);
        let columns = columns.min(self.kept.len());
        let (across, down) = (wide + GAP, high + LABEL + GAP);
        let (width, height) = (GAP + columns * across, GAP + self.kept.len().div_ceil(columns) * down);
        let mut sheet = Picture { width, height, rgb: BACKGROUND.repeat(width * height) };
        for (n, (picture, label)) in self.kept.iter().enumerate() {
            let (left, top) = (GAP + n % columns * across, GAP + n / columns * down);
            text::draw(&mut sheet, label, left, top + 4, 2, INK);
            for (row, pixels) in picture.rgb.chunks(3 * picture.width.max(1)).enumerate() {
                sheet.rgb[3 * ((top + LABEL + row) * width + left)..][..pixels.len()].copy_from_slice(pixels);
            }
        }
        Some(sheet)
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// If nothing was added, or the picture cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, LabError> {
        self.picture().ok_or_else(|| LabError::failure("a contact sheet of no pictures cannot be made"))?.png()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_picked_evenly_with_both_ends() {
        assert!(picks(0).is_empty());
        assert_eq!(picks(1), [0]);
        assert_eq!(picks(5), [0, 1, 2, 3, 4]);
        assert_eq!(picks(12), (0..12).collect::<Vec<_>>());
        for frames in 13..200 {
            let picks = picks(frames);
            assert_eq!((picks.len(), picks[0], picks[11]), (12, 0, frames - 1));
            let gaps: Vec<usize> = picks.windows(2).map(|pair| pair[1] - pair[0]).collect();
            assert!(gaps.iter().max().unwrap() - gaps.iter().min().unwrap() <= 1, "{picks:?}");
        }
    }

    #[test]
    fn a_sheet_shows_its_pictures_in_rows() {
        let mut sheet = Sheet::new(40);
        assert!(sheet.picture().is_none() && sheet.png().is_err());
        for number in 0..40 {
            sheet.add(number, &Picture { width: 40, height: 20, rgb: vec![6 * number as u8; 2400] }, "step");
        }
        let picture = sheet.picture().unwrap();
        assert_eq!((picture.width, picture.height), (GAP + 4 * (20 + GAP), GAP + 3 * (10 + LABEL + GAP)));
        for (n, number) in picks(40).into_iter().enumerate() {
            let column = GAP + n % 4 * (20 + GAP) + 10;
            let row = GAP + n / 4 * (10 + LABEL + GAP) + LABEL + 5;
            assert_eq!(picture.rgb[3 * (row * picture.width + column)], 6 * number as u8, "picture {n}");
        }
        let inked = picture.rgb.chunks(3).filter(|pixel| *pixel == INK).count();
        assert!(inked > 12 * 100, "labels are drawn: {inked}");
    }
}
