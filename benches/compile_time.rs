//! What kernels cost to compile: crates of 1 to 20 kernels, each used in one and in three layouts.
//!
//! `cargo bench --bench compile_time` writes the crates, builds each in the release profile (all three versions of a loop's body, for baseline,
//! AVX2 and AVX-512 processors), and prints the time beyond that of a crate without kernels, whole and for each kernel in each layout. `CHECK=1` measures
//! `cargo check` instead: what the macro and type checking cost alone.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};

/// A kernel and a call of it, where `{n}` is its number and `{l}` a layout.
struct Template {
    name: &'static str,
    kernel: &'static str,
    call: &'static str,
}

/// A stream, a stencil, and a scatter: the three kinds of loops.
const TEMPLATES: [Template; 3] = [
    Template {
        name: "saxpy",
        kernel: "#[kernel]
fn kernel{n}(x: &Field<f32, _>, y: &mut Field<f32, _>, a: f32) {
    for p in y {
        y[p] += a * x[p] + {n}.0;
    }
}
",
        call: "    kernel{n}(&Field::<f32, {l}>::new([n]), &mut Field::<f32, {l}>::new([n]), 2.0);\n",
    },
    Template {
        name: "5-point stencil",
        kernel: "#[kernel]
fn kernel{n}(u: &Field<f32, _, Ij>, next: &mut Field<f32, _, Ij>) {
    for (i, j) in next.interior(1) {
        next[(i, j)] = 0.25 * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]) + {n}.0;
    }
}
",
        call: "    kernel{n}(&Field::<f32, {l}>::new([n, n]), &mut Field::<f32, {l}>::new([n, n]));\n",
    },
    Template {
        name: "particles to grid",
        kernel: "#[kernel]
fn kernel{n}(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>, inv_dx: f32) {
    for p in points {
        let at = points.x[p] * inv_dx + {n}.0;
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
",
        call: "    kernel{n}(&Field::<Point, {l}>::new([n]), &mut Field::<Node, {l}>::new([n, n]), 1.0);\n",
    },
];

const HEAD: &str = "use allotrope::prelude::*;

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

";

const LAYOUTS: [&str; 3] = ["Aos", "Soa", "AoSoA<16>"];

/// The program of so many kernels of these kinds in so many layouts.
fn program(kernels: usize, layouts: usize, kinds: &[&Template]) -> String {
    let (mut text, mut calls) = (HEAD.to_owned(), String::new());
    for n in 0..kernels {
        let kind = kinds[n % kinds.len()];
        text += &kind.kernel.replace("{n}", &n.to_string());
        for layout in &LAYOUTS[..layouts] {
            calls += &kind.call.replace("{n}", &n.to_string()).replace("{l}", layout);
        }
    }
    let _ = write!(text, "fn main() {{\n    let n = std::env::args().count() * 8;\n    let _ = n;\n{calls}}}\n");
    text
}

/// Builds a program, whose dependencies are built, and returns the time.
fn build(project: &Path, text: &str, check: bool) -> Duration {
    fs::write(project.join("src/main.rs"), text).expect("the program is written");
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args([if check { "check" } else { "build" }, "--release", "--quiet"]).current_dir(project);
    command.env("CARGO_TARGET_DIR", project.join("target")).env_remove("RUSTFLAGS");
    let start = Instant::now();
    let status = command.status().expect("cargo runs");
    assert!(status.success(), "the program of the bench does not compile");
    start.elapsed()
}

fn main() {
    // Cargo runs benches of a test run once, without `--bench`: nothing is measured then.
    if !env::args().any(|argument| argument == "--bench") {
        return;
    }
    let check = env::var_os("CHECK").is_some();
    let project = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile_time");
    fs::create_dir_all(project.join("src")).expect("a folder for the programs");
    let library = Path::new(env!("CARGO_MANIFEST_DIR")).join("dsl-runtime");
    let manifest = format!(
        "[package]\nname = \"compile-time\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nallotrope = {{ path = {library:?} }}\n"
    );
    fs::write(project.join("Cargo.toml"), manifest).expect("the manifest is written");
    let _ = fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock"), project.join("Cargo.lock"));
    let all: Vec<&Template> = TEMPLATES.iter().collect();
    build(&project, &program(0, 0, &all), check);
    // The shortest of three: everything else only adds to it.
    let measure = |kernels, layouts, kinds: &[&Template]| {
        let time = |round| build(&project, &(program(kernels, layouts, kinds) + &format!("// {round}\n")), check);
        (0..3).map(time).min().unwrap_or_default().as_secs_f64()
    };
    let empty = measure(0, 0, &all);
    println!("a crate without kernels: {empty:.2} s\n");
    println!("| kernels | layouts | beyond that, s | a kernel and layout, s |\n|---|---|---|---|");
    let line = |name: &str, kernels: usize, layouts: usize, kinds: &[&Template]| {
        let time = measure(kernels, layouts, kinds) - empty;
        println!("| {kernels} {name} | {layouts} | {time:.2} | {:.3} |", time / (kernels * layouts) as f64);
    };
    for kernels in [1, 5, 10, 20] {
        for layouts in [1, 3] {
            line("of all kinds", kernels, layouts, &all);
        }
    }
    for kind in &TEMPLATES {
        line(kind.name, 6, 3, &[kind]);
    }
}
