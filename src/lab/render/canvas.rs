//! Pixels in linear light.

use std::num::NonZero;
use std::sync::{Mutex, PoisonError};

use super::colour::Colour;

/// Pixels that a thread takes at a time.
const PIECE: usize = 1 << 14;

/// Calls `fill` with pieces of the pixels and the number of the first of each, on all cores of the machine.
pub(super) fn for_pieces<T: Send>(pixels: &mut [T], fill: impl Fn(usize, &mut [T]) + Sync) {
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get).min(pixels.len() / PIECE + 1);
    let pieces = Mutex::new(pixels.chunks_mut(PIECE).enumerate());
    let next = || pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        while let Some((n, piece)) = next() {
            fill(n * PIECE, piece);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
}

/// A picture in linear light, rows from the top.
#[derive(Clone, Debug)]
pub(super) struct Canvas {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) pixels: Vec<Colour>,
}

impl Canvas {
    /// A picture of what `shade` says at each pixel's column and row.
    pub(super) fn of(width: usize, height: usize, shade: impl Fn(usize, usize) -> Colour + Sync) -> Self {
        let mut pixels = vec![Colour::default(); width * height];
        for_pieces(&mut pixels, |first, piece| {
            for (n, pixel) in piece.iter_mut().enumerate() {
                *pixel = shade((first + n) % width, (first + n) / width);
            }
        });
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_is_filled_once() {
        for length in [0, 1, PIECE, PIECE + 1, 5 * PIECE - 7] {
            let mut pixels = vec![0; length];
            for_pieces(&mut pixels, |first, piece| {
                piece.iter_mut().enumerate().for_each(|(n, pixel)| *pixel += first + n + 1);
            });
            assert!(pixels.into_iter().eq(1..=length));
        }
    }

    #[test]
    fn pixels_know_their_places() {
        let canvas = Canvas::of(300, 200, |column, row| Colour([column as f32, row as f32, 0.0]));
        assert_eq!(canvas.pixels[7 * 300 + 5], Colour([5.0, 7.0, 0.0]));
        assert_eq!(canvas.halved().pixels[3 * 150 + 2], Colour([4.5, 6.5, 0.0]));
    }
}
