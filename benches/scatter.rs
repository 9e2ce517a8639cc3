//! Particle to grid under every schedule: `cargo bench --bench scatter [-- FILTER]`, as comma-separated values.
//!
//! Particles a cell, their order, how they are spread, and the grid's layout are swept. The schedules of a case are timed in turn, `PAIRS`
//! times (9), on `THREADS` threads (2). The last column is how much longer `Auto` takes than the fastest of the others, and the last line
//! tells in how many cases that is at most 15 %. `CHARTS` names a folder for a chart of each layout, spread and order.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::Instant;

use allotrope::prelude::*;
use allotrope_lab::lab::chart::{Line, LineChart};
use allotrope_lab::workloads::transfer::{Mpm, Node, Point, particle_to_grid};

/// A schedule, by name.
struct Named {
    name: &'static str,
    scatter: Scatter,
    deterministic: bool,
}

const SCHEDULES: [Named; 6] = [
    Named { name: "serial", scatter: Scatter::Serial, deterministic: false },
    Named { name: "private", scatter: Scatter::Private, deterministic: false },
    Named { name: "colored", scatter: Scatter::Colored, deterministic: false },
    Named { name: "atomic", scatter: Scatter::Atomic, deterministic: false },
    Named { name: "auto", scatter: Scatter::Auto, deterministic: false },
    Named { name: "auto_deterministic", scatter: Scatter::Auto, deterministic: true },
];

/// A number from the environment.
fn number(name: &str, usual: usize) -> usize {
    let text = std::env::var(name).ok();
    text.map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}: give a number")))
}

/// A well-mixed number from 0 to 1.
fn fraction(n: usize, key: u64) -> f32 {
    let mut bits = (n as u64 ^ key).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    bits = (bits ^ bits >> 32).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (bits >> 40) as f32 / (1u64 << 24) as f32
}

/// Particles over the middle of a unit square, or in a few discs in it; in the order of blocks of 4 x 4 cells, or in none.
fn points(count: usize, side: usize, clustered: bool, sorted: bool) -> Field<Point, Aos> {
    let place = |n: usize| {
        let (a, b) = (fraction(n, 1), fraction(n, 2));
        if !clustered {
            return vec2(a, b) * 0.9 + 0.05;
        }
        let (disc, radius) = ((n % 5) as f32, 0.06 * a.sqrt());
        let centre = vec2(0.2 + 0.15 * disc, 0.3 + 0.1 * (disc * 2.0 % 5.0));
        centre + radius * Vec2::from_angle(b * core::f32::consts::TAU)
    };
    let mut all: Vec<Vec2> = (0..count).map(place).collect();
    if sorted {
        let key = |x: &Vec2| {
            let cell = (*x * side as f32 - 0.5).as_ivec2();
            (cell.x / 4, cell.y / 4, cell.x, cell.y)
        };
        all.sort_by_key(key);
    }
    let mut points = Field::new([count]);
    for (p, x) in all.into_iter().enumerate() {
        points.set(p, Point { x, v: vec2(1.0, 0.5), c: Mat2::IDENTITY, j: 1.0 });
    }
    points
}

/// Medians in milliseconds of all schedules for one case.
fn measure<G: Layout<Ij>>(points: &Field<Point, Aos>, side: usize, threads: usize, times: usize) -> Vec<f64> {
    let (mut grid, mpm) = (Field::<Node, G>::new([side, side]), Mpm::new(side));
    let mut all = vec![Vec::new(); SCHEDULES.len()];
    for round in 0..=times {
        for (named, found) in SCHEDULES.iter().zip(&mut all) {
            let &Named { scatter, deterministic, .. } = named;
            let schedule = Schedule { scatter, deterministic, threads, ..Schedule::default() };
            let start = Instant::now();
            schedule.run(|| particle_to_grid(black_box(points), black_box(&mut grid), &mpm));
            // The first round fetches memory.
            if round > 0 {
                found.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    all.iter_mut().map(median).collect()
}

fn main() {
    let filter = std::env::args().skip(1).find(|arg| !arg.starts_with('-'));
    let (times, threads) = (number("PAIRS", 9).max(1), number("THREADS", 2));
    let names: Vec<&str> = SCHEDULES.iter().map(|named| named.name).collect();
    println!("layout,side,particles,particles_per_cell,spread,order,{}_ms,auto_over_best", names.join("_ms,"));
    let (mut near, mut cases) = (0, 0);
    let mut charts = BTreeMap::<String, Vec<Line>>::new();
    for side in [256, 1024] {
        for per_cell in [0.1, 0.5, 1.0, 2.0, 4.0, 16.0, 64.0] {
            for (clustered, spread) in [(false, "uniform"), (true, "clustered")] {
                for (sorted, order) in [(true, "sorted"), (false, "shuffled")] {
                    let count = (per_cell * (side * side) as f64) as usize;
                    if count > 1 << 22 {
                        continue;
                    }
                    let mut points: Option<Field<Point, Aos>> = None;
                    for (layout, measure) in [
                        ("row", measure::<Aos> as fn(&Field<Point, Aos>, usize, usize, usize) -> Vec<f64>),
                        ("sparse8", measure::<Sparse<8>>),
                    ] {
                        let case = format!("{layout},{side},{count},{per_cell},{spread},{order}");
                        if filter.as_ref().is_some_and(|filter| !case.contains(filter.as_str())) {
                            continue;
                        }
                        let points = points.get_or_insert_with(|| self::points(count, side, clustered, sorted));
                        let medians = measure(points, side, threads, times);
                        let best = medians[..4].iter().copied().fold(f64::INFINITY, f64::min);
                        let ratio = medians[4] / best;
                        let texts: Vec<String> = medians.iter().map(|time| format!("{time:.3}")).collect();
                        println!("{case},{},{ratio:.2}", texts.join(","));
                        cases += 1;
                        near += usize::from(ratio <= 1.15);
                        let lines = charts.entry(format!("{layout}-{side}-{spread}-{order}")).or_insert_with(|| {
                            let line = |named: &Named| Line { name: named.name.replace('_', ", "), points: Vec::new() };
                            SCHEDULES.iter().map(line).collect()
                        });
                        for (line, time) in lines.iter_mut().zip(&medians) {
                            line.points.push([per_cell, time * 1e6 / count as f64]);
                        }
                    }
                }
            }
        }
    }
    println!(
        "# `auto` is within 15 % of the best in {near} of {cases} cases, on {threads} threads, {times} times each"
    );
    if let Some(folder) = std::env::var_os("CHARTS").map(PathBuf::from) {
        std::fs::create_dir_all(&folder).expect("the folder for charts");
        for (case, lines) in charts {
            let chart = LineChart {
                title: "Particle to grid".into(),
                subtitle: format!("{} on {threads} threads, medians of {times}", case.replace('-', ", ")),
                across: "particles a cell".into(),
                upwards: "nanoseconds a particle".into(),
                lines,
            };
            let svg = chart.svg().expect("a chart");
            std::fs::write(folder.join(format!("scatter-{case}.svg")), svg).expect("a chart's file");
        }
    }
}

/// Blocks of so many cells along each axis, behind pointers.
type Sparse<const N: usize> = layout!(pointer(ij).dense(ij, N).aos);
