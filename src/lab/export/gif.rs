//! Films as GIF, frame by frame: what does not change from one frame to the next is not written again, and each frame
//! has the 255 colours that suit it.

use std::io::Write;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::palette::Palette;
use crate::lab::errors::LabError;
use crate::lab::render::Picture;

/// The index of pixels that stay as they are.
const UNCHANGED: u8 = 255;

/// The shortest delay in hundredths of a second that viewers follow.
const LEAST_DELAY: u64 = 2;

/// A film that is played again and again. Of its frames the last alone is kept.
pub struct Gif<W: Write> {
    encoder: Encoder<W>,
    last: Option<Picture>,
    width: usize,
    height: usize,
    frames_a_second: f64,
    frames: u64,
    /// Hundredths of a second that the frames so far take.
    shown: u64,
}

impl<W: Write> Gif<W> {
    /// A film of pictures of that size, so many a second: at most 50, since viewers are no faster.
    ///
    /// # Errors
    /// If the size or the pace cannot be, or the output cannot be written.
    pub fn new(output: W, width: usize, height: usize, frames_a_second: f64) -> Result<Self, LabError> {
        let side = |pixels: usize| u16::try_from(pixels).ok().filter(|&pixels| pixels > 0);
        let (Some(columns), Some(rows)) = (side(width), side(height)) else {
            return Err(LabError::failure(format!(
                "a GIF of {width} x {height} pixels cannot be; sides are 1 to 65535"
            )));
        };
        if !(0.01..=50.0).contains(&frames_a_second) {
            let message = format!("a GIF of {frames_a_second} frames a second cannot be; 0.01 to 50 can");
            return Err(LabError::usage(message));
        }
        let mut encoder = Encoder::new(output, columns, rows, &[]).map_err(fault)?;
        encoder.set_repeat(Repeat::Infinite).map_err(fault)?;
        Ok(Self { encoder, last: None, width, height, frames_a_second, frames: 0, shown: 0 })
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// If it has another size, or the output cannot be written.
    pub fn add(&mut self, picture: &Picture) -> Result<(), LabError> {
        if (picture.width, picture.height) != (self.width, self.height) {
            return Err(LabError::failure(format!(
                "a frame of {} x {} pixels does not belong in a GIF of {} x {}",
                picture.width, picture.height, self.width, self.height
            )));
        }
        // Delays are hundredths of a second: they are rounded so that the film as a whole keeps its pace.
        self.frames += 1;
        let end = (100.0 * self.frames as f64 / self.frames_a_second).round() as u64;
        let delay = (end.saturating_sub(self.shown)).max(LEAST_DELAY);
        self.shown += delay;
        let mut frame = self.changes(picture);
        frame.delay = delay.min(u64::from(u16::MAX)) as u16;
        self.encoder.write_frame(&frame).map_err(fault)?;
        self.last = Some(picture.clone());
        Ok(())
    }

    /// The smallest rectangle that holds all pixels that are not as in the last frame.
    fn changes(&self, picture: &Picture) -> Frame<'static> {
        let last = self.last.as_ref().map(|last| last.rgb.as_chunks::<3>().0);
        let pixels = picture.rgb.as_chunks::<3>().0;
        let changed = |pixel: usize| last.is_none_or(|last| last[pixel] != pixels[pixel]);
        let rgb = |pixel: usize| pixels[pixel].iter().fold(0, |rgb, &component| rgb << 8 | u32::from(component));
        let (mut left, mut right, mut top, mut bottom) = (self.width, 0, self.height, 0);
        let mut colours = Vec::new();
        for pixel in (0..pixels.len()).filter(|&pixel| changed(pixel)) {
            let (column, row) = (pixel % self.width, pixel / self.width);
            (left, right) = (left.min(column), right.max(column + 1));
            (top, bottom) = (top.min(row), bottom.max(row + 1));
            colours.push(rgb(pixel));
        }
        if colours.is_empty() {
            // A frame has at least one pixel.
            (left, right, top, bottom) = (0, 1, 0, 1);
        }
        let palette = Palette::of(colours, usize::from(UNCHANGED));
        let places = (top..bottom).flat_map(|row| (left..right).map(move |column| (column, row)));
        let indices = places.map(|(column, row)| {
            let pixel = row * self.width + column;
            if changed(pixel) { palette.entry(rgb(pixel), column, row) } else { UNCHANGED }
        });
        // The entry of what is unchanged is never seen, but it has to be there.
        let mut entries = palette.entries.clone();
        entries.resize(usize::from(UNCHANGED) + 1, [0; 3]);
        // Sides were checked to be of 16 bits.
        Frame {
            left: left as u16,
            top: top as u16,
            width: (right - left) as u16,
            height: (bottom - top) as u16,
            buffer: indices.collect(),
            palette: Some(entries.concat()),
            transparent: Some(UNCHANGED),
            dispose: DisposalMethod::Keep,
            ..Frame::default()
        }
    }

    /// Ends the film, and gives its output back.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn finish(self) -> Result<W, LabError> {
        self.encoder.into_inner().map_err(fault)
    }
}

fn fault(error: EncodingError) -> LabError {
    LabError::failure(format!("a GIF cannot be written: {error}"))
}

#[cfg(test)]
mod tests {
    use image::AnimationDecoder;
    use image::codecs::gif::GifDecoder;

    use super::*;

    /// A bright square that moves over a dark gradient.
    fn picture(place: usize) -> Picture {
        let pixel = |n: usize| {
            let (column, row) = (n % 48, n / 48);
            if column.abs_diff(place) < 4 && row.abs_diff(12) < 4 { [250, 180, 90] } else { [11, 15, 20 + row as u8] }
        };
        Picture { width: 48, height: 32, rgb: (0..48 * 32).flat_map(pixel).collect() }
    }

    fn film(places: &[usize], frames_a_second: f64) -> Vec<u8> {
        let mut gif = Gif::new(Vec::new(), 48, 32, frames_a_second).unwrap();
        for &place in places {
            gif.add(&picture(place)).unwrap();
        }
        gif.finish().unwrap()
    }

    #[test]
    fn frames_come_back_exactly_where_colours_are_few() {
        // The second frame is as the first, and the last as well.
        let places = [8, 8, 20, 33, 8];
        let bytes = film(&places, 12.0);
        assert!(bytes.windows(11).any(|piece| piece == b"NETSCAPE2.0"), "it is played again and again");
        let frames = GifDecoder::new(std::io::Cursor::new(&bytes)).unwrap().into_frames().collect_frames().unwrap();
        assert_eq!(frames.len(), places.len());
        let mut time = 0;
        for (n, (frame, &place)) in frames.iter().zip(&places).enumerate() {
            assert_eq!(frame.buffer().dimensions(), (48, 32));
            let rgb: Vec<u8> = frame.buffer().pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
            assert!(rgb == picture(place).rgb, "frame {n}");
            let (numerator, denominator) = frame.delay().numer_denom_ms();
            time += numerator / denominator;
        }
        // Twelfths of a second are no hundredths, but five of them are 0.42 of a second.
        assert_eq!(time, 420);
    }

    #[test]
    fn what_does_not_change_costs_nothing() {
        let one = film(&[8], 25.0).len();
        let standing = film(&[8; 20], 25.0).len() - one;
        let moving = film(&(4..24).collect::<Vec<_>>(), 25.0).len() - one;
        // A palette and some bytes a frame.
        assert!(standing < 19 * 810, "{standing} after {one}");
        assert!(moving < 19 * 950, "{moving} after {one}");
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let refused = |width, height, pace| Gif::new(Vec::new(), width, height, pace).err().map(|e| e.to_string());
        let message = "a GIF of 0 x 5 pixels cannot be; sides are 1 to 65535";
        assert_eq!(refused(0, 5, 10.0).as_deref(), Some(message));
        assert!(
            refused(70_000, 5, 10.0).is_some() && refused(5, 5, 51.0).is_some() && refused(5, 5, f64::NAN).is_some()
        );
        let mut gif = Gif::new(Vec::new(), 48, 30, 10.0).unwrap();
        let message = gif.add(&picture(3)).unwrap_err().to_string();
        assert_eq!(message, "a frame of 48 x 32 pixels does not belong in a GIF of 48 x 30");
    }
}
