//! Whole workloads as users write them, each against plain Rust, in several layouts, under each instruction set and on one and three
//! threads.

mod conjugate_gradient;
mod contract;
mod elasticity;
mod lanes;
mod mpm;
mod multigrid;
mod neighbours;
mod rigid_coupling;
mod small;
mod springs;
mod staggered;

use allotrope::prelude::*;

/// The instruction sets that the processor has and that loops are compiled for: builds with debug assertions have one version of them.
fn instruction_sets() -> Vec<Cpu> {
    let all = if cfg!(debug_assertions) { &[Cpu::Baseline][..] } else { &Cpu::ALL };
    all.iter().copied().filter(|cpu| cpu.available()).collect()
}

/// Runs under each instruction set, on one thread and on three, in blocks so small that all threads have some.
fn on_threads(run: impl Fn()) {
    for cpu in instruction_sets() {
        for threads in [1, 3] {
            Schedule { threads, grain: 8, cpu: Some(cpu), ..Schedule::default() }.run(&run);
        }
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
