//! What the fluid conserves, where it is the same to the last bit, and when it stops.

mod support;

use allotrope::prelude::*;
use support::*;

const DISK: &str = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = 64
length = 1.0
dt = 2e-4
material = { stiffness = 100.0, density = 2.0 }
body = [{ shape = "ball", center = [0.5, 0.5], radius = 0.2, spin = 2.0 }]
"#;

const DROP: &str = r#"
version = 1
solver = "mpm"
dimensions = 3
grid = [24, 32, 20]
length = 1.2
dt = 5e-4
gravity = [0.5, -9.8, 0.25]
material = { stiffness = 200.0, density = 3.0 }
body = [
    { shape = "ball", center = [0.6, 0.8, 0.5], radius = 0.2, velocity = [0.3, -1.0, 0.1], spin = [1.0, 2.0, -1.0] },
    { shape = "box", from = [0.2, 0.2, 0.2], to = [1.0, 0.4, 0.8], jitter = 0.5, seed = 3 },
]
"#;

#[test]
fn mass_is_exact_and_momentum_changes_by_gravity_alone() {
    let (scene, fall) = (mpm88(), 200u64);
    let mass = 8192.0 * (0.5f64 / 128.0).powi(2);
    for layout in layouts() {
        for scatter in [Scatter::Private, Scatter::Atomic] {
            let mut fluid = build(&scene, layout);
            advance(&mut *fluid, Schedule { scatter, ..Schedule::default() }, fall);
            let (totals, grid) = (fluid.totals(), fluid.grid_mass().unwrap());
            assert_eq!(totals.mass, mass);
            // No update is lost: each particle's weights add up to one but for a rounding, and these roundings cancel.
            assert!((grid / mass - 1.0).abs() < 1e-7, "{layout}, {scatter}: {grid} of {mass}");
            let expected = mass * (-1.0 - 9.8 * 2e-4 * fall as f64);
            assert!(
                (totals.momentum[1] / expected - 1.0).abs() < 1e-5,
                "{layout}: {:?}, not {expected}",
                totals.momentum
            );
            assert!(totals.momentum[0].abs() < 1e-6 * mass, "{layout}: {:?}", totals.momentum);
        }
    }
}

#[test]
fn a_free_spinning_disk_keeps_its_angular_momentum() {
    let scene = scene(DISK);
    let about_center = |totals: allotrope_solvers::Totals| {
        totals.angular_momentum[2] - 0.5 * totals.momentum[1] + 0.5 * totals.momentum[0]
    };
    for layout in layouts() {
        let mut fluid = build(&scene, layout);
        let start = about_center(fluid.totals());
        // A rigid disk has m R^2 omega / 2, the affine part adds 1 / (R / dx)^2 of it.
        let rigid = 2.0 * std::f64::consts::PI * 0.2f64.powi(4) / 2.0 * 2.0;
        assert!((start / rigid - 1.0 - (1.0 / 12.8f64).powi(2)).abs() < 0.02, "{start}, not {rigid}");
        advance(&mut *fluid, Schedule::default(), 1000);
        let end = about_center(fluid.totals());
        assert!((end / start - 1.0).abs() < 1e-4, "{layout}: from {start} to {end}");
    }
}

#[test]
fn layouts_agree_in_space() {
    let scene = scene(DROP);
    let schedule = Schedule { scatter: Scatter::Serial, ..Schedule::default() };
    let mut first = build(&scene, "aos+row");
    advance(&mut *first, schedule, 60);
    assert_eq!(first.totals().mass, build(&scene, "aos+row").totals().mass);
    for layout in layouts() {
        let mut fluid = build(&scene, layout);
        advance(&mut *fluid, schedule, 60);
        assert!(difference(&fluid.positions(), &first.positions()) < 1e-6, "{layout}");
    }
}

#[test]
fn a_spinning_ball_in_space_keeps_momentum_and_angular_momentum() {
    let mut scene = scene(DROP);
    own(&mut scene).bodies.truncate(1);
    scene.gravity = [0.0; 3];
    own(&mut scene).bodies[0].velocity = [0.0; 3];
    let mut fluid = build(&scene, "aosoa16+blocked4");
    let start = fluid.totals();
    advance(&mut *fluid, Schedule::default(), 200);
    let end = fluid.totals();
    let size = start.angular_momentum.iter().map(|l| l * l).sum::<f64>().sqrt();
    for axis in 0..3 {
        assert!(
            (end.angular_momentum[axis] - start.angular_momentum[axis]).abs() < 1e-4 * size,
            "{start:?} became {end:?}"
        );
        assert!(end.momentum[axis].abs() < 1e-5 * end.mass, "{end:?}");
    }
    assert!((fluid.grid_mass().unwrap() / end.mass - 1.0).abs() < 1e-7);
}

fn bits(scene: &allotrope_solvers::Scene, layout: &str, schedule: Schedule, steps: u64) -> Vec<[f64; 3]> {
    let mut fluid = build(scene, layout);
    advance(&mut *fluid, schedule, steps);
    let mut state = fluid.positions();
    state.extend(fluid.velocities());
    state
}

#[test]
fn deterministic_runs_are_the_same_bits_for_any_threads_and_instruction_set() {
    let plane = mpm88();
    let space = scene(DROP);
    for (scene, steps) in [(&plane, 40), (&space, 20)] {
        for layout in ["aos+row", "aosoa16+blocked4"] {
            for scatter in [Scatter::Private, Scatter::Serial] {
                let with = |threads, cpu| Schedule {
                    threads,
                    scatter,
                    deterministic: true,
                    cpu: Some(cpu),
                    ..Schedule::default()
                };
                let first = bits(scene, layout, with(1, Cpu::Baseline), steps);
                for cpu in instruction_sets() {
                    for threads in [1, 2, 3, 8] {
                        let state = bits(scene, layout, with(threads, cpu), steps);
                        assert!(state == first, "{layout}, {scatter}, {cpu}, {threads} threads");
                    }
                }
            }
        }
    }
}

#[test]
fn a_step_in_which_a_particle_is_too_fast_is_refused_with_step_and_particle() {
    // Stable at first, by the bound; then gravity makes the particles too fast for the cells.
    let mut scene = mpm88();
    scene.gravity = [0.0, -2e5, 0.0];
    let mut fluid = build(&scene, "soa+soa");
    let error = (0..100).find_map(|_| fluid.step().err()).unwrap();
    assert_eq!(error.step, 1);
    let message = error.to_string();
    assert!(message.starts_with("stopped at step 1: particle 0 (fluid) at (0."), "{message}");
    assert!(
        message.contains(
            "moved more than a cell, at 41.000 of at most 39.062, and 8191 others; make `dt = 0.0002` smaller"
        ),
        "{message}"
    );
}

#[test]
fn what_is_not_finite_is_found_at_its_step() {
    let mut scene = mpm88();
    scene.gravity = [0.0, f64::NAN, 0.0];
    let mut fluid = build(&scene, "aos+row");
    let error = fluid.step().unwrap_err();
    assert!(error.to_string().starts_with("stopped at step 1: particle 0 (fluid) is not finite, at ("), "{error}");
}

#[test]
fn fluid_comes_to_rest_under_its_own_pressure() {
    // A pool as wide as its box, let down gently: at its floor the pressure is rho g h, so it is compressed by rho g h
    // / E.
    let pool = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = 32
length = 1.0
dt = 4e-4
gravity = [0.0, -9.8]
material = { stiffness = 400.0, density = 1.0 }
body = [{ shape = "box", from = [0.046875, 0.046875], to = [0.953125, 0.5] }]
"#;
    let scene = scene(pool);
    let mut fluid = build(&scene, "aos+row");
    let height = |positions: &[[f64; 3]]| positions.iter().map(|x| x[1]).sum::<f64>() / positions.len() as f64;
    let mut mean = 0.0;
    // Averaged over the slow sloshing that is left.
    for _ in 0..40 {
        advance(&mut *fluid, Schedule::default(), 100);
        mean += height(&fluid.positions()) / 40.0;
    }
    // The column's own weight lowers its middle by rho g h^2 / 3 E.
    let depth = 0.5 - 0.046875;
    let expected = 0.046875 + depth / 2.0 - 9.8 * depth * depth / (3.0 * 400.0);
    assert!((mean - expected).abs() < 0.01 * depth, "{mean}, not {expected}");
}
