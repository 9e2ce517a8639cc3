//! The fluid against a reference in double precision, in every layout under every schedule and instruction set.

mod support;

use allotrope::prelude::*;
use allotrope_solvers::scene::Reorder;
use support::*;

/// After so many steps every coordinate is within this of the reference.
const BOUNDS: [(u64, f64); 3] = [(100, 1e-6), (500, 1e-5), (1000, 2e-4)];

fn follows_the_reference(schedule: Schedule, instruction_sets: &[Cpu]) {
    let expected: Vec<_> = BOUNDS.iter().map(|(step, _)| reference_positions(&format!("x{step}"))).collect();
    let scene = mpm88();
    for &cpu in instruction_sets {
        for layout in layouts() {
            let mut fluid = build(&scene, layout);
            for ((step, bound), expected) in BOUNDS.iter().zip(&expected) {
                let left = step - fluid.steps();
                advance(&mut *fluid, Schedule { cpu: Some(cpu), ..schedule }, left);
                let error = difference(&fluid.positions(), expected);
                assert!(error <= *bound, "{layout}, {cpu}, {schedule:?}: off by {error:.2e} after {step} steps");
            }
        }
    }
}

fn scattered(scatter: Scatter) -> Schedule {
    Schedule { scatter, threads: 2, ..Schedule::default() }
}

#[test]
fn serial() {
    follows_the_reference(scattered(Scatter::Serial), &[Cpu::best()]);
}

#[test]
fn private() {
    follows_the_reference(scattered(Scatter::Private), &instruction_sets());
}

#[test]
fn atomic() {
    follows_the_reference(scattered(Scatter::Atomic), &[Cpu::best()]);
}

#[test]
fn deterministic() {
    follows_the_reference(Schedule { deterministic: true, ..scattered(Scatter::Private) }, &[Cpu::best()]);
}

#[test]
fn the_first_step_is_the_references_too() {
    let mut fluid = build(&mpm88(), "aos+row");
    fluid.step().unwrap();
    assert!(difference(&fluid.positions(), &reference_positions("x1")) < 3e-8);
}

#[test]
fn sorting_changes_neither_order_nor_state() {
    let mut sorted = mpm88();
    own(&mut sorted).reorder = Reorder::Every(7);
    for layout in layouts() {
        let mut fluid = build(&sorted, layout);
        advance(&mut *fluid, Schedule::default(), 100);
        let error = difference(&fluid.positions(), &reference_positions("x100"));
        assert!(error <= 1e-6, "{layout}: off by {error:.2e}");
        assert_eq!(fluid.kernel_names(), ["scatter", "grid", "gather", "sort"]);
    }
}

/// Taichi's own check of its example: means of powers of all coordinates, heights doubled, after 500 steps.
#[test]
fn taichis_moments() {
    let mut scene = mpm88();
    let at = |n: usize| [(n % 64) as f64 / 64.0 * 0.4 + 0.2, n as f64 / 4096.0 * 0.4 + 0.05, 0.0];
    own(&mut scene).bodies[0].shape = allotrope_solvers::scene::Shape::Points((0..4096).map(at).collect());
    own(&mut scene).bodies[0].velocity = [0.0, -3.0, 0.0];
    for layout in layouts() {
        let mut fluid = build(&scene, layout);
        advance(&mut *fluid, Schedule::default(), 500);
        let positions = fluid.positions();
        for (power, expected) in (1..).zip([0.31722742, 0.15826741, 0.10224003, 0.07810827]) {
            let sum: f64 = positions.iter().map(|x| x[0].powi(power) + (2.0 * x[1]).powi(power)).sum();
            let mean = sum / (2 * positions.len()) as f64;
            assert!((mean / expected - 1.0).abs() < 0.01, "{layout}: {mean}, not {expected}");
        }
    }
}
