//! What the probe costs: a program with it left out of the library's source, one as programs are built unless they ask for it, and one that asks and
//! records nothing, in turn.
//!
//! `cargo bench --bench probe` builds the three, runs each `ROUNDS` times (21 unless told) in turn, and prints the median time of each kernel, and the
//! ratio to that of the first program with its 95 % bootstrap interval. Where `valgrind` is installed it also prints the instructions of a call, which are
//! the same in every run.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use allotrope_lab::lab::statistics::{median, median_ratio_interval};

/// Three kernels, each timed alone: the shortest of some calls, in nanoseconds. Arguments name a kernel and how often it is called.
const PROGRAM: &str = "use std::hint::black_box;
use std::time::Instant;

use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
pub struct Point {
    x: Vec2,
    v: Vec2,
}

#[derive(Record, Clone, Copy, Default)]
pub struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn saxpy(x: &Field<f32, _>, y: &mut Field<f32, _>, a: f32) {
    for p in y {
        y[p] += a * x[p];
    }
}

#[kernel]
fn jacobi(u: &Field<f32, _, Ij>, next: &mut Field<f32, _, Ij>) {
    for (i, j) in next.interior(1) {
        next[(i, j)] = 0.25 * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]);
    }
}

#[kernel]
fn particle_to_grid(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>, inv_dx: f32) {
    for p in points {
        let at = points.x[p] * inv_dx;
        let base = (at - 0.5).as_ivec2();
        let fx = at - base.as_vec2();
        let w = [0.5 * (1.5 - fx) * (1.5 - fx), 0.75 - (fx - 1.0) * (fx - 1.0), 0.5 * (fx - 0.5) * (fx - 0.5)];
        for (i, j) in unroll!(0..3, 0..3) {
            let weight = w[i as usize].x * w[j as usize].y;
            grid.v[base + ivec2(i, j)] += weight * points.v[p];
            grid.m[base + ivec2(i, j)] += weight;
        }
    }
}

fn shortest(name: &str, mut call: impl FnMut()) {
    let mut arguments = std::env::args().skip(1);
    if arguments.next().is_some_and(|only| only != name) {
        return;
    }
    let calls = arguments.next().map_or(200, |calls| calls.parse().unwrap());
    let time = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_nanos()
    };
    println!(\"{name} {}\", (0..calls).map(time).min().unwrap());
}

fn main() {
    let (x, mut y) = (Field::<f32, Aos>::new([1 << 16]), Field::<f32, Aos>::new([1 << 16]));
    shortest(\"saxpy\", || saxpy(black_box(&x), &mut y, black_box(2.0)));
    let (u, mut next) = (Field::<f32, Aos>::new([256, 256]), Field::<f32, Aos>::new([256, 256]));
    shortest(\"jacobi\", || jacobi(black_box(&u), &mut next));
    let mut points = Field::<Point, Aos>::new([1 << 14]);
    for p in 0..1 << 14 {
        let x = vec2((p / 128) as f32, (p % 128) as f32) / 160.0 + 0.1;
        points.set(p, Point { x, v: Vec2::ONE });
    }
    let mut grid = Field::<Node, Aos>::new([128, 128]);
    shortest(\"particle_to_grid\", || particle_to_grid(black_box(&points), &mut grid, black_box(127.0)));
}
";

/// A way of building the program.
struct Build {
    name: &'static str,
    features: &'static str,
    flags: &'static str,
}

const BUILDS: [Build; 3] = [
    Build { name: "left out of the source", features: "", flags: "--cfg allotrope_unprobed" },
    Build { name: "off", features: "", flags: "" },
    Build { name: "on, nothing recorded", features: "\"probe\"", flags: "" },
];

/// Builds the program, and gives its file.
fn built(number: usize, build: &Build) -> std::path::PathBuf {
    let project = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("probe{number}"));
    fs::create_dir_all(project.join("src")).expect("a folder for the program");
    let library = Path::new(env!("CARGO_MANIFEST_DIR")).join("dsl-runtime");
    let manifest = format!(
        "[package]\nname = \"probed\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nallotrope = {{ path = {library:?}, features = [{}] }}\n",
        build.features
    );
    fs::write(project.join("Cargo.toml"), manifest).expect("the manifest is written");
    fs::write(project.join("src/main.rs"), PROGRAM).expect("the program is written");
    let _ = fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock"), project.join("Cargo.lock"));
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["build", "--release", "--quiet"]).current_dir(&project);
    command.env("CARGO_TARGET_DIR", project.join("target")).env("RUSTFLAGS", build.flags);
    assert!(command.status().expect("cargo runs").success(), "the program of the bench does not compile");
    project.join("target/release/probed")
}

/// The times of a run: kernels and nanoseconds.
fn run(program: &Path) -> Vec<(String, f64)> {
    let output = Command::new(program).env("ALLOTROPE_THREADS", "1").output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let line = |line: &str| {
        let (name, time) = line.split_once(' ').expect("a name and a time");
        (name.to_string(), time.parse().expect("nanoseconds"))
    };
    String::from_utf8_lossy(&output.stdout).lines().map(line).collect()
}

/// Instructions of so many calls of a kernel, with all that is around them; nothing where they cannot be counted.
fn instructions_of(program: &Path, kernel: &str, calls: u32) -> Option<f64> {
    let mut command = Command::new("valgrind");
    command
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .arg(kernel)
        .arg(calls.to_string());
    // It knows no AVX-512.
    let cpu = if allotrope::Cpu::Avx2.available() { "avx2" } else { "baseline" };
    let output = command.env("ALLOTROPE_THREADS", "1").env("ALLOTROPE_CPU", cpu).output().ok()?;
    let report = String::from_utf8_lossy(&output.stderr);
    let count = report.lines().find_map(|line| line.split_once("Collected :"))?.1;
    output.status.success().then(|| count.trim().parse().ok())?
}

/// Instructions of one call.
fn instructions(program: &Path, kernel: &str) -> Option<f64> {
    const CALLS: u32 = 40;
    let of = |calls| instructions_of(program, kernel, calls);
    Some((of(CALLS + 1)? - of(1)?) / f64::from(CALLS))
}

fn main() {
    // Cargo runs benches of a test run once, without `--bench`: nothing is measured then.
    if !env::args().any(|argument| argument == "--bench") {
        return;
    }
    let rounds = env::var("ROUNDS").map_or(21, |text| text.parse().expect("`ROUNDS` is a number"));
    let programs: Vec<_> = BUILDS.iter().enumerate().map(|(number, build)| built(number, build)).collect();
    // By program and round.
    let mut times = vec![Vec::new(); BUILDS.len()];
    for round in 0..rounds {
        for n in (0..BUILDS.len()).map(|n| (round + n) % BUILDS.len()) {
            times[n].push(run(&programs[n]));
        }
    }
    println!(
        "| kernel | probe | microseconds | ratio | 95 % interval | instructions | ratio |\n|---|---|---|---|---|---|---|"
    );
    let kernels: Vec<String> = times[0][0].iter().map(|(name, _)| name.clone()).collect();
    for (k, kernel) in kernels.iter().enumerate() {
        let of = |n: usize| -> Vec<f64> { times[n].iter().map(|run: &Vec<(String, f64)>| run[k].1).collect() };
        let counts: Vec<_> = programs.iter().map(|program| instructions(program, kernel)).collect();
        for (n, build) in BUILDS.iter().enumerate() {
            let (own, without) = (of(n), of(0));
            let [low, high] = median_ratio_interval(&own, &without);
            let (time, ratio) = (1e-3 * median(&own), median(&own) / median(&without));
            let counted = match (counts[n], counts[0]) {
                (Some(own), Some(without)) => format!("{own:.0} | {:.4}", own / without),
                _ => "not counted | ".into(),
            };
            println!("| {kernel} | {} | {time:.3} | {ratio:.4} | {low:.4} to {high:.4} | {counted} |", build.name);
        }
    }
    println!("\n{rounds} runs of each program in turn, each time the shortest of 200 calls");
}
