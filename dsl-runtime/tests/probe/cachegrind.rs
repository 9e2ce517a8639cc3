//! The modelled caches against those of `valgrind --tool=cachegrind`, where that is installed.

use std::path::Path;
use std::process::Command;

use allotrope::prelude::*;
use allotrope::probe::{Cache, Caches, record};

use super::{Node, jacobi};

/// What both model.
const CACHES: Caches =
    Caches { first: Cache { bytes: 32 << 10, ways: 8 }, second: Cache { bytes: 512 << 10, ways: 16 } };

#[kernel]
fn saxpy(x: &Field<f32, _>, y: &mut Field<f32, _>) {
    for i in y {
        y[i] = 0.5 * x[i] + y[i];
    }
}

#[derive(Record, Clone, Copy, Default)]
struct Point {
    x: Vec2,
    m: f32,
}

#[kernel]
fn scatter(points: &Field<Point, _>, grid: &mut Field<f32, _, Ij>) {
    for p in points {
        let base = points.x[p].as_ivec2();
        for (i, j) in unroll!(0..3, 0..3) {
            grid[base + ivec2(i, j)] += points.m[p] / 9.0;
        }
    }
}

/// Launches a kernel so many times, on one thread.
fn launches(kernel: &str, times: usize) {
    let work = || match kernel {
        "saxpy" => {
            let (x, mut y) = (Field::<f32, Aos>::new([1 << 17]), Field::<f32, Aos>::new([1 << 17]));
            (0..times).for_each(|_| saxpy(&x, &mut y));
        }
        "jacobi" => {
            let mut nodes = Field::<Node, AoSoA<16>>::new([200, 256]);
            (0..times).for_each(|_| jacobi(&mut nodes));
        }
        "scatter" => {
            // In no order: each particle meets other lines than the one before it.
            let mut points = Field::<Point, Soa>::new([20_000]);
            for p in 0..20_000 {
                let (x, y) = ((p * 7919) % 499, (p * 104_729) % 509);
                points.members_mut().x.set([p], vec2(x as f32, y as f32));
            }
            let mut grid = Field::<f32, Blocked<8>>::new([512, 512]);
            (0..times).for_each(|_| scatter(&points, &mut grid));
        }
        other => panic!("no kernel {other}"),
    };
    Schedule { threads: 1, scatter: Scatter::Serial, ..Schedule::default() }.run(work);
}

/// What the tests below start under `cachegrind`; by itself it does nothing.
#[test]
fn child() {
    if let Ok(task) = std::env::var("CACHEGRIND_TASK") {
        let (kernel, times) = task.split_once(' ').expect("a kernel and a number");
        launches(kernel, times.parse().expect("a number"));
    }
}

/// Misses of both levels, as `cachegrind` counts them for the whole program.
fn cachegrind(kernel: &str, times: usize, out: &Path) -> [f64; 2] {
    let cache = |Cache { bytes, ways }: Cache| format!("{bytes},{ways},64");
    let run = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=yes"])
        .arg(format!("--D1={}", cache(CACHES.first)))
        .arg(format!("--LL={}", cache(CACHES.second)))
        .arg(format!("--cachegrind-out-file={}", out.display()))
        .arg(std::env::current_exe().expect("this program"))
        .args(["--exact", "cachegrind::child", "--test-threads=1"])
        .env_remove("ALLOTROPE_CPU")
        .env("CACHEGRIND_TASK", format!("{kernel} {times}"))
        .output()
        .expect("valgrind");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let text = std::fs::read_to_string(out).expect("what cachegrind wrote");
    let find = |name: &str| text.lines().find_map(|line| line.strip_prefix(name)).expect("its summary");
    let events: Vec<&str> = find("events:").split_whitespace().collect();
    let summary: Vec<f64> = find("summary:").split_whitespace().map(|n| n.parse().expect("a number")).collect();
    let sum = |wanted: &str| -> f64 {
        events
            .iter()
            .zip(&summary)
            .filter(|(event, _)| event.starts_with('D') && event.contains(wanted))
            .map(|(_, n)| n)
            .sum()
    };
    [sum("1m"), sum("Lm")]
}

fn agree(kernel: &str) {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("valgrind is not installed: `{kernel}` is not compared");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    // What else the program does is the same in both runs.
    let [few, many] = [2, 6].map(|times| cachegrind(kernel, times, &folder.path().join(format!("{times}"))));
    let modelled = |times: usize| {
        let ((), recording) = record(&CACHES, || launches(kernel, times)).expect("a recording");
        let members = recording.loops.iter().flat_map(|counts| &counts.members);
        members.fold([0.0; 2], |sum: [f64; 2], m| [sum[0] + m.misses[0] as f64, sum[1] + m.misses[1] as f64])
    };
    let [first, last] = [2, 6].map(modelled);
    for level in 0..2 {
        let (counted, ours) = (many[level] - few[level], last[level] - first[level]);
        let line = format!("{kernel}, level {}: {ours} misses in 4 launches, cachegrind {counted}", level + 1);
        println!("{line}");
        assert!(ours > 1000.0 && (ours / counted - 1.0).abs() < 0.1, "{line}");
    }
}

#[test]
fn a_stream() {
    agree("saxpy");
}

#[test]
fn a_stencil() {
    agree("jacobi");
}

#[test]
fn a_scatter() {
    agree("scatter");
}
