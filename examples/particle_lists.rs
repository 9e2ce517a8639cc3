//! Particles in lists of cells, and how many neighbours each has. `cargo run --release --example particle_lists`

use std::time::Instant;

use allotrope::prelude::*;

/// Each cell has a list of up to 1024 particles, in chunks of 32 as it grows; blocks of 4 by 4 cells are there where there are particles.
pub type Cells = layout!(pointer(ij).dense(ij, 4).dynamic(k, 1024, chunk = 32).aos);

/// Cells along each axis of the unit square.
pub const CELLS: usize = 128;
/// How far neighbours are: a cell's width.
pub const RADIUS: f32 = 1.0 / CELLS as f32;

/// The cell of a point.
fn cell_of(x: Vec2) -> IVec2 {
    (x * CELLS as f32).as_ivec2()
}

/// Puts every particle into the list of its cell.
#[kernel]
pub fn bin(x: &Field<Vec2, _>, cells: &mut Field<u32, Cells, Ijk>) {
    cells.clear();
    for p in x {
        cells.append(cell_of(x[p]), p as u32);
    }
}

/// Counts the particles within the radius, in the lists of the cells around.
#[kernel]
pub fn count(x: &Field<Vec2, _>, cells: &Field<u32, Cells, Ijk>, neighbours: &mut Field<u32, _>) {
    for p in x {
        let (own, cell) = (x[p], cell_of(x[p]));
        let mut near = 0;
        for (a, b) in unroll!(-1..2, -1..2) {
            let side = cell + ivec2(a, b);
            if side.min_element() >= 0 && side.max_element() < CELLS as i32 {
                for entry in cells.row(side) {
                    let q = cells[entry];
                    near += u32::from(q != p as u32 && (x[q] - own).length_squared() < RADIUS * RADIUS);
                }
            }
        }
        neighbours[p] = near;
    }
}

/// Particles on a spiral with three arms.
pub fn spiral(count: usize) -> Field<Vec2, Soa> {
    let mut x = Field::<Vec2, Soa>::new([count]);
    for p in 0..count {
        let draw = |key: u32| random::<f32>(7, (p as u64, key));
        let (arm, along) = ((draw(0) * 3.0).floor(), draw(1).sqrt());
        let angle = 2.1 * arm + 4.0 * along + 0.25 * (draw(2) - 0.5);
        x.set(p, Vec2::splat(0.5) + 0.48 * along * Vec2::from_angle(angle));
    }
    x
}

/// The same number by looking at all particles.
pub fn counted(x: &[Vec2], p: usize) -> u32 {
    let near = |&(q, other): &(usize, &Vec2)| q != p && (*other - x[p]).length_squared() < RADIUS * RADIUS;
    x.iter().enumerate().filter(near).count() as u32
}

fn main() {
    let count_of = 100_000;
    let x = spiral(count_of);
    let mut cells = Field::<u32, Cells>::new([CELLS, CELLS]);
    let mut neighbours = Field::<u32, Soa>::new([count_of]);
    bin(&x, &mut cells); // touches the memory, so that the times are those of the kernels
    count(&x, &cells, &mut neighbours);
    let start = Instant::now();
    bin(&x, &mut cells);
    let binned = start.elapsed();
    count(&x, &cells, &mut neighbours);
    let counted_in = start.elapsed() - binned;
    let lists = (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j)));
    let lengths: Vec<usize> = lists.map(|cell| cells.row_len(cell)).filter(|&len| len > 0).collect();
    println!(
        "{} particles in {} lists, up to {} in one; {} KiB",
        cells.active_len(),
        lengths.len(),
        lengths.iter().max().copied().unwrap_or_default(),
        cells.bytes() >> 10
    );
    println!(
        "put into lists in {:.1} ms, neighbours counted in {:.1} ms",
        binned.as_secs_f64() * 1e3,
        counted_in.as_secs_f64() * 1e3
    );
    let all = x.to_vec();
    assert!((0..count_of).step_by(997).all(|p| neighbours.get(p) == counted(&all, p)));
    println!("{:.1} neighbours on average", neighbours.map_reduce(f64::from, 0.0, |a, b| a + b) / count_of as f64);
}
