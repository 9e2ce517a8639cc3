//! Pictures as bytes.

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

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
        let mut bytes = Vec::new();
        PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, FilterType::Adaptive)
            .write_image(&self.rgb, self.width as u32, self.height as u32, ExtendedColorType::Rgb8)
            .map_err(|error| LabError::failure(format!("a picture cannot be encoded: {error}")))?;
        Ok(bytes)
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
    }
}
