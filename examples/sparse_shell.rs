//! A moving narrow band: the cells near the surface of a sphere, and no others. `cargo run --release --example sparse_shell`

use std::time::Instant;

use allotrope::prelude::*;

/// A cell of the band.
#[derive(Record, Clone, Copy, Default, Debug)]
pub struct Cell {
    /// From the surface, in cells; positive outside.
    pub distance: f32,
    /// Twice the mean curvature of the surface through the cell.
    pub curvature: f32,
}

/// Blocks of 8 by 8 by 8 cells under pointers, with an activity bit for each cell.
pub type Band = layout!(pointer(ijk).bitmasked(ijk, 8).soa);

/// Cells along each axis.
pub const SIZE: usize = 256;
/// The sphere's radius, in cells.
pub const RADIUS: f32 = 80.0;
/// How far the band reaches to both sides of the surface, in cells.
pub const WIDTH: f32 = 3.0;

/// The distance of a cell from the sphere around a centre.
fn distance(cell: IVec3, centre: Vec3) -> f32 {
    (cell.as_vec3() - centre).length() - RADIUS
}

/// Makes the band around a first centre.
#[kernel]
pub fn fill(band: &mut Field<Cell, _, Ijk>, centre: Vec3) {
    let end = SIZE as i32 - 1;
    for (i, j, k) in ndrange!(1..end, 1..end, 1..end) {
        let d = distance(ivec3(i, j, k), centre);
        if d.abs() < WIDTH {
            band.distance[(i, j, k)] = d;
        }
    }
}

/// Moves the sphere by less than a cell: cells beside the band that come near become active, those that are far do not stay so.
#[kernel]
pub fn follow(band: &mut Field<Cell, _, Ijk>, centre: Vec3) {
    for cell in band {
        for step in [IVec3::X, IVec3::Y, IVec3::Z, IVec3::NEG_X, IVec3::NEG_Y, IVec3::NEG_Z] {
            if distance(cell + step, centre).abs() < WIDTH {
                band.activate(cell + step);
            }
        }
    }
    // The new cells are among these.
    for cell in band {
        let d = distance(cell, centre);
        band.distance[cell] = d;
        if d.abs() >= WIDTH {
            band.deactivate(cell);
        }
    }
}

/// The Laplacian of the distance, which is the curvature: that of a sphere is two over its radius.
#[kernel]
pub fn curve(band: &mut Field<Cell, _, Ijk>) {
    for (i, j, k) in band {
        let sides = band.distance[(i - 1, j, k)] + band.distance[(i + 1, j, k)];
        let ends = band.distance[(i, j - 1, k)] + band.distance[(i, j + 1, k)];
        let levels = band.distance[(i, j, k - 1)] + band.distance[(i, j, k + 1)];
        band.curvature[(i, j, k)] = sides + ends + levels - 6.0 * band.distance[(i, j, k)];
    }
}

/// The largest error of the curvature, in parts of it, where all neighbours are in the band.
pub fn error(band: &Field<Cell, Band, Ijk>) -> f32 {
    let inner = band.active_iter().map(|(_, cell)| cell).filter(|cell| cell.distance.abs() < WIDTH - 1.01);
    inner.map(|cell| (cell.curvature * (RADIUS + cell.distance) / 2.0 - 1.0).abs()).fold(0.0, f32::max)
}

fn main() {
    let mut band = Field::<Cell, Band>::new([SIZE; 3]);
    let mut centre = Vec3::new(100.0, 128.0, 128.0);
    fill(&mut band, centre);
    let dense = SIZE.pow(3) * size_of::<Cell>();
    println!("a dense field of {SIZE}^3 cells takes {} MiB", dense >> 20);
    let (mut most, start, steps) = (0, Instant::now(), 80);
    for step in 0..=steps {
        if step % 20 == 0 {
            curve(&mut band);
            println!(
                "step {step:3}: {} cells in {} blocks, {:.1} MiB; the curvature is right to {:.1e}",
                band.active_len(),
                band.blocks().len(),
                band.bytes() as f64 / 1_048_576.0,
                error(&band)
            );
        }
        // Blocks that the band leaves are those that it enters.
        most = most.max(band.bytes());
        centre += vec3(0.7, 0.1, -0.1);
        follow(&mut band, centre);
    }
    println!(
        "{:.1} ms a step, {:.1} MiB at most",
        start.elapsed().as_secs_f64() * 1e3 / f64::from(steps),
        most as f64 / 1_048_576.0
    );
}
