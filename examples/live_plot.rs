//! A film of a simulation of one's own: two chemicals react and spread (Gray and Scott), and corals grow.
//! `cargo run --release --example live_plot [FOLDER]`

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use allotrope::prelude::*;
use allotrope_lab::lab::errors::{self, LabError};
use allotrope_lab::lab::export::gif::Gif;
use allotrope_lab::lab::output;
use allotrope_lab::lab::render::Picture;

/// Concentrations of the chemical that is fed, and of the one that eats it.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub struct Dish {
    /// What is fed.
    pub food: f32,
    /// What eats it.
    pub coral: f32,
}

/// How fast food comes in.
pub const FEED: f32 = 0.0545;
/// How fast coral dies, beside what is washed out.
pub const DEATH: f32 = 0.062;
/// How fast both spread, in cells squared a step.
pub const SPREAD: Dish = Dish { food: 0.2, coral: 0.1 };

/// One step from `old` to `new`: both spread to their four neighbours, two corals and a food make three corals. The
/// border stays as it is.
#[kernel]
pub fn step(old: &Field<Dish, _, Ij>, new: &mut Field<Dish, _, Ij>) {
    for (i, j) in new.interior(1) {
        let (food, coral) = (old.food[(i, j)], old.coral[(i, j)]);
        let foods = old.food[(i - 1, j)] + old.food[(i + 1, j)] + old.food[(i, j - 1)] + old.food[(i, j + 1)];
        let corals = old.coral[(i - 1, j)] + old.coral[(i + 1, j)] + old.coral[(i, j - 1)] + old.coral[(i, j + 1)];
        let eaten = food * coral * coral;
        new.food[(i, j)] = food + SPREAD.food * (foods - 4.0 * food) - eaten + FEED * (1.0 - food);
        new.coral[(i, j)] = coral + SPREAD.coral * (corals - 4.0 * coral) + eaten - (FEED + DEATH) * coral;
    }
}

/// Colours every cell by its coral, lit from the upper left as if it were high; returns how much coral there is.
#[kernel]
pub fn colour(dish: &Field<Dish, _, Ij>, pixels: &mut Field<[u8; 3], _, Ij>) -> f32 {
    let mut total = 0.0;
    for (i, j) in pixels.interior(1) {
        let coral = dish.coral[(i, j)];
        total += coral;
        let slope = dish.coral[(i + 1, j)] - dish.coral[(i - 1, j)] + dish.coral[(i, j + 1)] - dish.coral[(i, j - 1)];
        let tone = (coral / 0.35).min(1.0);
        let (sea, reef) = (vec3(0.03, 0.07, 0.16), vec3(1.0, 0.55, 0.35));
        let lit = sea.lerp(reef, tone) * (1.0 + 1.5 * slope).clamp(0.4, 1.6);
        pixels[(i, j)] = (255.0 * lit.clamp(Vec3::ZERO, Vec3::ONE)).as_u8vec3().to_array();
    }
    total
}

/// A dish full of food, with a few corals in it.
pub fn dish<L: Layout<Ij>>(shape: [usize; 2]) -> Field<Dish, L, Ij> {
    let mut dish = Field::<Dish, L>::new(shape);
    dish.fill(Dish { food: 1.0, coral: 0.0 });
    for seed in 1..=7 {
        let unit = (f64::from(seed) * dvec2(0.754_877_666_246_693, 0.569_840_290_998_053)).fract();
        let corner = ((0.1 + 0.65 * unit) * dvec2(shape[0] as f64, shape[1] as f64)).as_uvec2();
        for cell in 0..100 {
            dish.set(corner + uvec2(cell / 10, cell % 10), Dish { food: 0.5, coral: 0.25 });
        }
    }
    dish
}

/// Simulates and films so many frames, each of them so many steps after the last. No frame is kept: films may be long.
pub fn film(shape: [usize; 2], frames: usize, steps: usize, file: &Path) -> Result<(), LabError> {
    let mut old = dish::<Split>(shape);
    let mut new = old.clone();
    let mut pixels = Field::<[u8; 3], Aos>::new(shape);
    let fault = |error| LabError::machine(format!("`{}` cannot be written: {error}", file.display()));
    let output = BufWriter::new(File::create(file).map_err(fault)?);
    let [height, width] = shape;
    let mut gif = Gif::new(output, width, height, 25.0)?;
    let start = Instant::now();
    for frame in 1..=frames {
        let total = colour(&old, &mut pixels);
        gif.add(&Picture { width, height, rgb: pixels.iter().flatten().collect() })?;
        for _ in 0..steps {
            step(&old, &mut new);
            std::mem::swap(&mut old, &mut new);
        }
        if frame % 10 == 0 {
            println!(
                "frame {frame} of {frames}, {:.1} s: coral {:.4} on average",
                start.elapsed().as_secs_f32(),
                total / pixels.len() as f32
            );
        }
    }
    gif.finish()?.flush().map_err(fault)
}

fn run() -> Result<(), LabError> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "allotrope-out".into()));
    output::folder(&folder)?;
    let file = folder.join("live_plot.gif");
    film([240, 320], 100, 100, &file)?;
    println!("The film is {}", file.display());
    Ok(())
}

fn main() -> ExitCode {
    errors::report(run)
}
