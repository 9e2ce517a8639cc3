//! Conway's Life on a plane without bounds: a glider gun fires for 10,000 generations. `cargo run --release --example game_of_life`

use std::path::Path;
use std::time::Instant;

use allotrope::prelude::*;

/// Blocks of 8 by 8 cells, found by hashing, with an activity bit for each cell. Those that live are active, and no others: the plane has no
/// end, and memory is held for the blocks where something lives.
pub type Plane = layout!(hash(ij).bitmasked(ij, 8).aos);

/// Gosper's gun of 1970: every 30 generations it is what it was, and a glider of five cells is on its way.
pub const GUN: [&str; 9] = [
    "........................O...........",
    "......................O.O...........",
    "............OO......OO............OO",
    "...........O...O....OO............OO",
    "OO........O.....O...OO..............",
    "OO........O...O.OO....O.O...........",
    "..........O.....O.......O...........",
    "...........O...O....................",
    "............OO......................",
];

/// The next generation. Around each living cell, those are looked at that it could bring to life; several may, which `|=` allows.
#[kernel]
pub fn step(now: &Field<u8, Plane, Ij>, next: &mut Field<u8, Plane, Ij>) {
    next.clear();
    for ij in now {
        for (a, b) in unroll!(-1..2, -1..2) {
            let cell = ij + ivec2(a, b);
            let mut around = 0;
            for (d, e) in unroll!(-1..2, -1..2) {
                around += now[cell + ivec2(d, e)];
            }
            // Three with itself, or four of which it is one.
            if around == 3 || (around == 4 && now[cell] == 1) {
                next[cell] |= 1;
            }
        }
    }
}

/// The gun, its upper left corner at the origin.
pub fn gun() -> Field<u8, Plane, Ij> {
    let mut plane = Field::unbounded();
    for (i, row) in GUN.iter().enumerate() {
        for (j, _) in row.bytes().enumerate().filter(|&(_, cell)| cell == b'O') {
            plane.set((i, j), 1);
        }
    }
    plane
}

/// How many cells live in a generation that is a multiple of 30: the gun, and five for each glider.
pub fn population(generation: usize) -> usize {
    36 + 5 * (generation / 30)
}

/// Draws what is near the gun.
pub fn draw(plane: &Field<u8, Plane, Ij>, file: &Path) -> image::ImageResult<()> {
    let picture = image::GrayImage::from_fn(640, 640, |x, y| {
        let (i, j) = (y as i32 / 4 - 20, x as i32 / 4 - 20);
        image::Luma([if plane.get([i, j]) == 1 { 240 } else { 16 }])
    });
    picture.save(file)
}

fn main() {
    let (mut now, mut next) = (gun(), Field::<u8, Plane, Ij>::unbounded());
    let (start, generations) = (Instant::now(), 10_000);
    for generation in 0..=generations {
        if generation % 30 == 0 {
            assert_eq!(now.active_len(), population(generation), "generation {generation}");
        }
        if generation % 1000 == 0 {
            let (cells, blocks, bytes) = (now.active_len(), now.blocks().len(), now.bytes());
            println!("generation {generation:6}: {cells:5} cells in {blocks:4} blocks, {bytes:6} bytes");
        }
        step(&now, &mut next);
        std::mem::swap(&mut now, &mut next);
    }
    let farthest = now.active_iter().map(|(at, _)| at.max_element()).max().unwrap_or_default();
    println!("{:.1} s; the first glider is {farthest} cells away", start.elapsed().as_secs_f64());
    let file = Path::new("game_of_life.png");
    match draw(&now, file) {
        Ok(()) => println!("the gun is in {}", file.display()),
        Err(error) => println!("{} cannot be written: {error}", file.display()),
    }
}
