//! The time of a particle and of a cell from few to many: `cargo bench --bench scaling [-- FILTER]`, as comma-separated values.
//!
//! Every kernel is timed `REPEATS` times (15) at each size, on `THREADS` threads (2); medians. The last column is how many times as long an
//! element takes as at the kernel's best size. `CHART` names a file for a chart of all.

use std::hint::black_box;
use std::time::Instant;

use allotrope::prelude::*;
use allotrope_lab::lab::chart::{Line, LineChart};
use allotrope_lab::lab::machine;
use allotrope_lab::lab::statistics::median;
use allotrope_lab::workloads::stencils::{jacobi, laplacian};
use allotrope_lab::workloads::streams::saxpy;
use allotrope_lab::workloads::transfer::{Mpm, Node, Point, grid_to_particle, particle_to_grid, sorted_points};

/// A number from the environment.
fn number(name: &str, usual: usize) -> usize {
    let text = std::env::var(name).ok();
    text.map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}: give a number")))
}

/// How often calls are timed; each time as many calls are made as take a few milliseconds.
struct Clock {
    repeats: usize,
}

impl Clock {
    /// The median of nanoseconds an element.
    fn time(&self, elements: usize, mut call: impl FnMut()) -> f64 {
        call();
        let start = Instant::now();
        call();
        let calls = (5e-3 / start.elapsed().as_secs_f64().max(1e-9)).ceil().min(1e5) as u32;
        let sample = || {
            let start = Instant::now();
            (0..calls).for_each(|_| call());
            start.elapsed().as_secs_f64() * 1e9 / f64::from(calls) / elements as f64
        };
        median(&std::iter::repeat_with(sample).take(self.repeats).collect::<Vec<_>>())
    }
}

/// Particles of a square, four a cell, sorted by cell.
fn particles(count: usize) -> (Field<Point, Aos>, usize) {
    let side = ((count / 4) as f64).sqrt() as usize;
    let mut points = Field::<Point, Aos>::new([count]);
    for (place, point) in sorted_points(count, side).into_iter().enumerate() {
        points.set(place, point);
    }
    (points, side)
}

/// A kernel's name, and the nanoseconds of an element among so many.
type Measured = (&'static str, fn(&Clock, usize) -> (usize, f64));

const KERNELS: [Measured; 5] = [
    ("P2G, a particle", |clock, count| {
        let (points, side) = particles(count);
        let (mut grid, mpm) = (Field::<Node, Aos>::new([side, side]), Mpm::new(side));
        (count, clock.time(count, || particle_to_grid(black_box(&points), &mut grid, &mpm)))
    }),
    ("G2P, a particle", |clock, count| {
        let (mut points, side) = particles(count);
        let (grid, mpm) = (Field::<Node, Aos>::new([side, side]), Mpm::new(side));
        (count, clock.time(count, || grid_to_particle(black_box(&mut points), &grid, &mpm)))
    }),
    ("saxpy, a value", |clock, count| {
        let (x, mut y) = (Field::<f32, Aos>::new([count]), Field::<f32, Aos>::new([count]));
        (count, clock.time(count, || saxpy(black_box(0.5), &x, &mut y)))
    }),
    ("Jacobi, a cell", |clock, count| {
        let n = (count as f64).sqrt() as usize;
        let (u, mut v) = (Field::<f32, Aos>::new([n, n]), Field::<f32, Aos>::new([n, n]));
        (n * n, clock.time(n * n, || jacobi(black_box(0.25), &u, &mut v)))
    }),
    ("7-point Laplacian, a cell", |clock, count| {
        let n = (count as f64).cbrt() as usize;
        let (p, mut q) = (Field::<f32, Aos>::new([n; 3]), Field::<f32, Aos>::new([n; 3]));
        (n * n * n, clock.time(n * n * n, || laplacian(black_box(&p), &mut q)))
    }),
];

fn main() {
    let filter = std::env::args().skip(1).find(|arg| !arg.starts_with('-'));
    let (clock, threads) = (Clock { repeats: number("REPEATS", 15).max(1) }, number("THREADS", 2));
    let schedule = Schedule { threads, ..Schedule::default() };
    println!("kernel,elements,ns_per_element,over_best");
    let mut lines = Vec::new();
    for (name, measure) in KERNELS {
        if filter.as_ref().is_some_and(|filter| !name.contains(filter.as_str())) {
            continue;
        }
        let sizes = (0..7).map(|n| 10f64.powf(4.0 + 0.5 * f64::from(n)) as usize);
        let points: Vec<[f64; 2]> = sizes
            .map(|size| {
                let (elements, time) = schedule.run(|| measure(&clock, size));
                [elements as f64, time]
            })
            .collect();
        let best = points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
        for [elements, time] in &points {
            println!("\"{name}\",{elements},{time:.4},{:.2}", time / best);
        }
        lines.push(Line { name: name.into(), points });
    }
    if let Some(file) = std::env::var_os("CHART") {
        let chart = LineChart {
            title: "The time of an element".into(),
            subtitle: format!("{}, {threads} threads, {}", machine::processor(), machine::instruction_set()),
            across: "particles or cells".into(),
            upwards: "nanoseconds".into(),
            lines,
        };
        std::fs::write(file, chart.svg().expect("a chart")).expect("the chart's file");
    }
}
