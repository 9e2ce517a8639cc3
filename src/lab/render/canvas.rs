//! Pixels in linear light.

use super::colour::Colour;

/// A picture in linear light, rows from the top.
#[derive(Clone, Debug)]
pub(super) struct Canvas {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) pixels: Vec<Colour>,
}

impl Canvas {
    /// A picture of what `shade` says at each pixel's column and row.
    pub(super) fn of(width: usize, height: usize, mut shade: impl FnMut(usize, usize) -> Colour) -> Self {
        let mut pixels = Vec::with_capacity(width * height);
        for row in 0..height {
            pixels.extend((0..width).map(|column| shade(column, row)));
        }
        Self { width, height, pixels }
    }

    /// Half the size: each pixel the mean of four.
    pub(super) fn halved(&self) -> Self {
        Self::of(self.width / 2, self.height / 2, |column, row| {
            let at = |c: usize, r: usize| self.pixels[(2 * row + r) * self.width + 2 * column + c];
            (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) * 0.25
        })
    }

    /// The bytes of sRGB, three a pixel.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|pixel| pixel.srgb()).collect()
    }
}
