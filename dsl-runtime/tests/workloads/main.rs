//! Whole workloads as users write them, each against plain Rust, in several layouts and on one and three threads.

mod conjugate_gradient;
mod elasticity;
mod multigrid;
mod neighbours;
mod rigid_coupling;
mod small;
mod springs;
mod staggered;

use allotrope::prelude::*;

/// Runs on one thread and on three, in blocks so small that all threads have some.
fn on_threads(run: impl Fn()) {
    for threads in [1, 3] {
        Schedule { threads, grain: 8, ..Schedule::default() }.run(&run);
    }
}

/// Asserts that two lists are equal but for rounding: so much of their largest number.
#[track_caller]
fn close(ours: &[f32], theirs: &[f32], tolerance: f32) {
    assert_eq!(ours.len(), theirs.len());
    let largest = theirs.iter().fold(f32::MIN_POSITIVE, |largest, x| largest.max(x.abs()));
    for (at, (a, b)) in ours.iter().zip(theirs).enumerate() {
        assert!((a - b).abs() <= tolerance * largest, "{a} and {b} at {at}, of at most {largest}");
    }
}

/// Numbers between -1 and 1 without a pattern.
fn scattered(n: usize) -> f32 {
    2.0 * random::<f32>(1, n) - 1.0
}
