//! Own layouts: one kernel over six arrangements of the same records. `cargo run --release --example own_layout`

use std::time::Instant;

use allotrope::prelude::*;

/// A cell of a fluid: what is used together often, and what is not.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Cell {
    velocity: Vec2,
    pressure: f32,
    dye: Vec3,
    solid: bool,
}

/// Columns of tiles of 4 x 4 cells. In a tile, each member's values lie together.
type Tiled = layout!(dense(ji).dense(ij, 4).soa);

/// Velocity and pressure, which one kernel uses together, side by side; the dye split in its three components; then the flags.
/// A layout that names members says whose they are.
type Grouped = layout!(Cell: dense(ij).place([velocity, pressure], [split(dye)], [solid]));

/// Takes the pressure's gradient off the velocity. It says nothing of layouts, and is compiled once for each that it meets.
#[kernel]
fn project(now: &Field<Cell, _, Ij>, next: &mut Field<Cell, _, Ij>) {
    for (i, j) in next.interior(1) {
        let across = now.pressure[(i + 1, j)] - now.pressure[(i - 1, j)];
        let up = now.pressure[(i, j + 1)] - now.pressure[(i, j - 1)];
        next.velocity[(i, j)] = now.velocity[(i, j)] - 0.5 * vec2(across, up);
    }
}

/// Runs the kernel in the layout `L`, tells what it takes, and returns the result in a layout that all share.
fn measure<L: Layout<Ij>>(name: &str, start: &Field<Cell, Aos, Ij>) -> Field<Cell, Aos, Ij> {
    let now = start.relayout::<L>();
    let mut next = now.clone();
    project(&now, &mut next); // touches the memory, so that the time is that of the kernel
    let begin = Instant::now();
    for _ in 0..20 {
        project(&now, &mut next);
    }
    let time = begin.elapsed() / 20;
    println!("{name:12} {:>10} bytes  {:>6} µs", next.bytes(), time.as_micros());
    next.relayout()
}

fn main() {
    // 1001 is no multiple of a block's 4 cells: cells beyond the shape take bytes, but no loop and no index reaches them.
    let mut start = Field::<Cell, Aos>::new([1001, 500]);
    for i in 0..1001 {
        for j in 0..500 {
            let pressure = (0.02 * i as f32).sin() * (0.03 * j as f32).cos();
            start.set([i, j], Cell { velocity: Vec2::X, pressure, dye: Vec3::splat(pressure), solid: false });
        }
    }
    let results = [
        measure::<Aos>("aos", &start),
        measure::<Soa>("soa", &start),
        measure::<Split>("split", &start),
        measure::<AoSoA<16>>("aosoa, 16", &start),
        measure::<Tiled>("tiled", &start),
        measure::<Grouped>("grouped", &start),
    ];
    assert!(results.iter().all(|result| result.iter().eq(results[0].iter())), "a layout never changes a result");
}
