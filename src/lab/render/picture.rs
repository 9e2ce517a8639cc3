//! Pictures as bytes.

use std::io::Cursor;

use png::{BitDepth, ColorType, Compression, Decoder, DecodingError, Encoder, EncodingError, Filter};

use super::canvas::Canvas;
use super::colour::Colour;
use crate::lab::errors::LabError;

/// A picture in sRGB, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green and blue of each pixel.
    pub rgb: Vec<u8>,
}

impl Picture {
    pub(super) fn of(canvas: &Canvas) -> Self {
        Self { width: canvas.width, height: canvas.height, rgb: canvas.bytes() }
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// If the picture cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, LabError> {
        let fault = |error: EncodingError| LabError::failure(format!("a picture cannot be encoded: {error}"));
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Balanced);
        encoder.set_filter(Filter::Adaptive);
        let mut writer = encoder.write_header().map_err(fault)?;
        writer.write_image_data(&self.rgb).map_err(fault)?;
        writer.finish().map_err(fault)?;
        Ok(bytes)
    }

    /// The picture in the bytes of a PNG file that [`png`](Self::png) made.
    pub(crate) fn of_png(bytes: &[u8]) -> Result<Self, String> {
        let fault = |error: DecodingError| error.to_string();
        let mut reader = Decoder::new(Cursor::new(bytes)).read_info().map_err(fault)?;
        let mut rgb = vec![0; reader.output_buffer_size().ok_or("it is larger than memory")?];
        let frame = reader.next_frame(&mut rgb).map_err(fault)?;
        if (frame.color_type, frame.bit_depth) != (ColorType::Rgb, BitDepth::Eight) {
            return Err(format!(
                "its pixels are {:?} of {:?} bits, not three bytes",
                frame.color_type, frame.bit_depth
            ));
        }
        Ok(Self { width: frame.width as usize, height: frame.height as usize, rgb })
    }

    /// Half the size, rounded down: each pixel the mean of four, in linear light.
    pub fn halved(&self) -> Self {
        let light: Vec<f32> = (0..=255).map(|byte| Colour::hex(byte).0[2]).collect();
        let pixels = self.rgb.as_chunks().0.iter();
        let pixels = pixels.map(|rgb: &[u8; 3]| Colour(rgb.map(|component| light[usize::from(component)]))).collect();
        Self::of(&Canvas { width: self.width, height: self.height, pixels }.halved())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_takes_means_of_light() {
        let row = |colours: [u8; 3]| colours.map(|grey| [grey; 3]).concat();
        let rgb = [row([0, 255, 9]), row([255, 0, 9]), row([7, 7, 9])].concat();
        let half = Picture { width: 3, height: 3, rgb }.halved();
        // Half the light of white is 188 in sRGB.
        assert_eq!(half, Picture { width: 1, height: 1, rgb: vec![188; 3] });
    }

    #[test]
    fn a_png_holds_the_picture() {
        let picture = Picture { width: 5, height: 3, rgb: (0..45).collect() };
        let read = image::load_from_memory(&picture.png().unwrap()).unwrap().to_rgb8();
        assert_eq!((read.dimensions(), read.as_raw()), ((5, 3), &picture.rgb));
        assert_eq!(Picture::of_png(&picture.png().unwrap()), Ok(picture));
    }

    #[test]
    fn bytes_that_are_no_picture_are_told() {
        let png = Picture { width: 5, height: 3, rgb: (0..45).collect() }.png().unwrap();
        assert!(Picture::of_png(&png[..40]).is_err() && Picture::of_png(b"text").is_err());
    }
}
