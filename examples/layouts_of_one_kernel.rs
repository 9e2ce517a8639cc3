//! Which layout suits my kernel? A telescope's exposure in seven layouts of the stars: checked to agree, measured, and
//! drawn as a chart. `cargo run --release --example layouts_of_one_kernel [FOLDER]`

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use allotrope::prelude::*;
use allotrope_lab::lab::compare::{Comparison, Results};
use allotrope_lab::lab::errors::{self, LabError};
use allotrope_lab::lab::output;

/// Pixels of the detector along each axis.
pub const PIXELS: usize = 256;
/// From the catalogue to the exposure.
pub const YEARS: f32 = 8.0;

/// A star of the catalogue: 56 bytes, of which an exposure uses 20.
#[derive(Record, Clone, Copy, Default)]
pub struct Star {
    /// Place on the map of the sky, from 0 to 1 along both axes.
    pub position: Vec2,
    /// Motion on the sky a year.
    pub motion: Vec2,
    colour: Vec3,
    temperature: f32,
    distance: f64,
    name: u64,
    /// Photons that arrive during the exposure.
    pub photons: u32,
}

/// What is used together lies together, the rest apart: it is not fetched.
type Grouped = layout!(Star: dense(i).place([position, motion, photons], [colour, temperature, distance, name]));

/// Adds every star's photons to the pixel where it stands that many years after the catalogue was made.
#[kernel]
pub fn expose(stars: &Field<Star, _>, detector: &mut Field<u32, _, Ij>, years: f32) {
    for ij in detector {
        detector[ij] = 0;
    }
    for s in stars {
        // The map of the sky has no border: what leaves it on one side comes in on the other.
        let place = (stars.position[s] + years * stars.motion[s]).fract_gl();
        let pixel = (place * PIXELS as f32).as_ivec2().min(IVec2::splat(PIXELS as i32 - 1));
        detector[pixel] += stars.photons[s]; // many stars meet in a pixel: no photon is lost
    }
}

/// A catalogue of that many stars all over the sky.
pub fn catalogue(stars: usize) -> Field<Star, Aos> {
    let mut catalogue = Field::<Star, Aos>::new([stars]);
    for s in 0..stars {
        let unit = (s as f64 * dvec2(0.754_877_666_246_693, 0.569_840_290_998_053)).fract().as_vec2();
        let photons = 100 + (s % 900) as u32;
        catalogue.set(s, Star { position: unit, motion: 0.01 * (unit - 0.5), photons, ..Star::default() });
    }
    catalogue
}

/// Enters the layout `L` in the comparison: what is called, and what the detector saw.
fn enter<L: Layout<I>>(comparison: &mut Comparison<'_>, name: &str, catalogue: &Field<Star, Aos>) {
    let (stars, detector) = (catalogue.relayout::<L>(), Field::<u32, Aos>::new([PIXELS, PIXELS]));
    let bytes = stars.bytes() + detector.bytes();
    comparison.add_with(
        name,
        bytes,
        (stars, detector),
        |(stars, detector)| expose(stars, detector, YEARS),
        |(_, detector)| detector.iter().map(f64::from).collect(),
    );
}

/// Measures so many repetitions of each layout, after a check that all of them see the same.
pub fn compare(stars: usize, repetitions: usize) -> Result<Results, LabError> {
    let catalogue = catalogue(stars);
    let mut comparison = Comparison::new("An exposure in seven layouts of the stars", stars);
    comparison.within(0.0); // a layout never changes a result
    enter::<Aos>(&mut comparison, "aos", &catalogue);
    enter::<Soa>(&mut comparison, "soa", &catalogue);
    enter::<Split>(&mut comparison, "split", &catalogue);
    enter::<AoSoA<4>>(&mut comparison, "aosoa, 4", &catalogue);
    enter::<AoSoA<16>>(&mut comparison, "aosoa, 16", &catalogue);
    enter::<AoSoA<64>>(&mut comparison, "aosoa, 64", &catalogue);
    enter::<Grouped>(&mut comparison, "grouped", &catalogue);
    comparison.run(repetitions)
}

/// Draws a chart of what was measured, and gives its file's name.
pub fn draw(results: &Results, folder: &Path) -> Result<PathBuf, LabError> {
    output::folder(folder)?;
    let chart = folder.join("layouts_of_one_kernel.svg");
    output::write(&chart, results.chart()?.as_bytes())?;
    Ok(chart)
}

fn run() -> Result<(), LabError> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "allotrope-out".into());
    let results = compare(1 << 19, 15)?;
    println!("{}", results.table());
    println!("The chart is {}", draw(&results, Path::new(&folder))?.display());
    Ok(())
}

fn main() -> ExitCode {
    errors::report(run)
}
