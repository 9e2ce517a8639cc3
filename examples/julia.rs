//! The Julia set of z² + c, as a picture. `cargo run --release --example julia [FILE.png]`

use std::path::Path;

use allotrope::prelude::*;
use image::{ImageResult, Rgb, RgbImage};

/// Pixels across and up.
const SIZE: [u32; 2] = [640, 320];
/// After so many iterations a point counts as one of the set.
const MOST: u32 = 50;

/// Counts, for every pixel, the iterations of z² + c until |z| reaches 20; c moves with the time `t`.
#[kernel]
pub fn iterate(counts: &mut Field<u32, _, Ij>, t: f32) {
    let c = vec2(-0.8, 0.2 * t.cos());
    let [width, height] = counts.shape().map(|n| n as i32);
    for (i, j) in counts {
        let mut z = vec2((2 * i - width) as f32, (2 * j - height) as f32) / height as f32; // from -2 - i to 2 + i
        let mut count = 0;
        while count < MOST && z.length_squared() < 20.0 * 20.0 {
            z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
            count += 1;
        }
        counts[(i, j)] = count;
    }
}

/// The picture's counts at the time `t`.
pub fn counts<L: Layout<Ij>>(t: f32) -> Field<u32, L, Ij> {
    let mut counts = Field::<u32, L>::new(SIZE.map(|n| n as usize));
    iterate(&mut counts, t);
    counts
}

/// Writes the counts as a picture, the second axis upwards.
pub fn draw<L: Layout<Ij>>(counts: &Field<u32, L, Ij>, file: &Path) -> ImageResult<()> {
    let picture = RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
        let s = (counts.get([x, SIZE[1] - 1 - y]) as f32 / MOST as f32).sqrt();
        Rgb([s.sqrt(), s, s * s].map(|c| (255.0 * c) as u8)) // black, red, yellow, white
    });
    picture.save(file)
}

fn main() -> ImageResult<()> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "julia.png".into());
    let counts = counts::<Aos>(0.0);
    draw(&counts, Path::new(&file))?;
    println!("{file}: {} iterations in all", counts.iter().sum::<u32>());
    Ok(())
}
