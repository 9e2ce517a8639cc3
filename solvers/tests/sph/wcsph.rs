//! The weakly compressible solver: what it conserves, and that layouts and ways of finding neighbours agree.

use allotrope::prelude::*;
use allotrope_solvers::scene::Folder;
use allotrope_solvers::sph::wcsph::{Boundary, Extremes, Fluid, TimeStep, WcsphSetup};
use allotrope_solvers::sph::{Smoothing, Spline};
use allotrope_solvers::{Scene, Simulation, SolverInfo, solver};

fn wcsph() -> &'static SolverInfo {
    solver("wcsph").unwrap()
}

fn scene(name: &str, overrides: &[&str]) -> Scene {
    let info = wcsph().scenes.iter().find(|scene| scene.name == name).unwrap();
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    Scene::parse_with(info.text, name, Folder::BuiltIn, &overrides).unwrap()
}

fn run(scene: &Scene, layout: &str, steps: u64) -> Box<dyn Simulation> {
    let mut simulation = (wcsph().build)(scene, layout).unwrap();
    (0..steps).for_each(|_| simulation.step().unwrap());
    simulation
}

fn layouts() -> impl Iterator<Item = &'static str> {
    wcsph().layouts.iter().map(|layout| layout.name)
}

/// Two drops that meet in the plane, off centre.
const DROPS: &str = r#"
version = 1
solver = "wcsph"
dimensions = 2
extent = [1.0, 1.0]
spacing = 0.02
smoothing = 1.3
dt = 1e-2

[fluid]
density = 1000.0
sound = 20.0
alpha = 0.1

[[body]]
shape = "ball"
center = [0.3, 0.45]
radius = 0.15
velocity = [1.0, 0.0]

[[body]]
shape = "ball"
center = [0.7, 0.55]
radius = 0.15
velocity = [-0.5, 0.25]
spin = 2.0
"#;

#[test]
fn without_walls_momentum_stays_to_round_off() {
    let monaghan = ["fluid.viscosity=\"monaghan\"", "fluid.beta=0.2", "fluid.tension=0.5"];
    let variants: [&[&str]; 4] = [
        &[],
        &["density=\"summation\""],
        &monaghan,
        &["kernel=\"gaussian\"", "fluid.state=\"linear\"", "fluid.suction=true"],
    ];
    for (overrides, layout) in variants.iter().flat_map(|overrides| layouts().map(move |layout| (overrides, layout))) {
        let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
        let scene = Scene::parse_with(DROPS, "drops", Folder::BuiltIn, &overrides).unwrap();
        let mut simulation = (wcsph().build)(&scene, layout).unwrap();
        let (start, energy) = (simulation.totals(), simulation.energy());
        (0..200).for_each(|_| simulation.step().unwrap());
        let end = simulation.totals();
        // Of the order of what the bodies have; 200 steps of some thousand sums of single precision each.
        let scale = start.mass * 1.0;
        for axis in 0..3 {
            let change = (end.momentum[axis] - start.momentum[axis]).abs() / scale;
            assert!(change < 1e-6, "{overrides:?}, {layout}: momentum along {axis} changed by {change:e}");
            let change = (end.angular_momentum[axis] - start.angular_momentum[axis]).abs() / scale;
            assert!(change < 2e-6, "{overrides:?}, {layout}: angular momentum about {axis} changed by {change:e}");
        }
        let after = simulation.energy();
        let lost = energy.kinetic - after.kinetic;
        assert!(lost > 0.01 * energy.kinetic, "{overrides:?}, {layout}: the drops meet: {energy:?}, {after:?}");
        assert_eq!(start.mass, end.mass);
    }
}

/// The largest difference of a coordinate.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let both = a.iter().flatten().zip(b.iter().flatten());
    both.map(|(a, b)| (a - b).abs()).fold(0.0, |most, d| if d > most || d.is_nan() { d } else { most })
}

#[test]
fn all_layouts_and_schedules_agree() {
    let small: [&[&str]; 4] = [
        &["spacing=0.005715"],
        &["spacing=0.005715", "density=\"summation\"", "reorder=0"],
        &["spacing=0.1", "smoothing=1.2", "neighbours.skin=0.5"],
        &["spacing=0.05", "sides.boundary=\"repulsion\"", "reorder=7"],
    ];
    for (name, overrides) in ["dam-break", "dam-break", "dam-break-3d", "bunny-drop"].into_iter().zip(small) {
        let scene = scene(name, overrides);
        let expected = run(&scene, "aos+lists", 60);
        let spacing = expected.spacing();
        for layout in layouts() {
            for threads in [1, 2] {
                let schedule = Schedule { threads, ..Schedule::default() };
                let other = schedule.run(|| run(&scene, layout, 60));
                let off = difference(&expected.positions(), &other.positions()) / spacing;
                assert!(off < 1e-3, "{name} {overrides:?}, {layout}, {threads} threads: off by {off} spacings");
                assert!((other.time() / expected.time() - 1.0).abs() < 1e-4);
            }
        }
    }
}

#[test]
fn a_restored_run_goes_on_to_the_bit() {
    let scene = scene("dam-break", &["spacing=0.005715"]);
    for layout in layouts() {
        let mut first = run(&scene, layout, 23);
        let state = first.save();
        let mut second = (wcsph().build)(&scene, layout).unwrap();
        second.restore(&state).unwrap();
        for _ in 0..40 {
            first.step().unwrap();
            second.step().unwrap();
        }
        assert_eq!((first.steps(), first.time(), first.dt()), (second.steps(), second.time(), second.dt()), "{layout}");
        assert_eq!(first.positions(), second.positions(), "{layout}");
        let broken = allotrope_solvers::State { steps: 1, arrays: Vec::new() };
        assert!(second.restore(&broken).is_err());
        assert_eq!(first.positions(), second.positions(), "{layout}: a refused state changes nothing");
    }
}

#[test]
fn crowded_lists_stop_with_particle_and_count() {
    let scene = scene("dam-break", &["spacing=0.005715", "neighbours.most=12"]);
    let error = (wcsph().build)(&scene, "aos+lists").unwrap().step().unwrap_err();
    assert_eq!(error.step, 1);
    let parts = ["particle ", " has 25 particles near it, and its list holds at most 12; raise `neighbours.most`"];
    assert!(parts.iter().all(|part| error.message.contains(part)), "{error}");
    assert!((wcsph().build)(&scene, "aos+sorted").unwrap().step().is_ok());
}

fn fluid() -> Fluid<Ij> {
    Fluid {
        kernel: Smoothing::new(Spline::Cubic, 2, 0.5).unwrap(),
        mass: 1.0,
        density: 1000.0,
        sound: 10.0,
        exponent: 7,
        stiffness: 1000.0 * 100.0 / 7.0,
        offset: 1.0,
        suction: false,
        gravity: Vec2::ZERO,
        alpha: 0.5,
        beta: 0.0,
        local_sound: false,
        tension: 0.0,
        boundary: Boundary::Repulsion,
        friction: 0.0,
    }
}

#[test]
fn pressure_sound_and_steps_follow_their_formulas() {
    let fluid = fluid();
    assert!((fluid.pressure(1010.0) / (1e5 / 7.0 * (1.01f32.powi(7) - 1.0)) - 1.0).abs() < 1e-4);
    assert_eq!((fluid.pressure(1000.0), fluid.pressure(900.0)), (0.0, 0.0));
    assert!(Fluid { suction: true, ..fluid }.pressure(900.0) < 0.0);
    // c = c0 (rho / rho0)^3 with the exponent 7: its square is the derivative of pressure by density.
    let slope = f64::from(fluid.pressure(1051.0) - fluid.pressure(1049.0)) / 2.0;
    assert!((f64::from(fluid.sound_at(1050.0)).powi(2) / slope - 1.0).abs() < 1e-3);
    let extremes = Extremes { acceleration_squared: 400.0, speed_squared: 4.0, density: 1050.0 };
    let step = TimeStep::new(&fluid, &extremes, 1.0);
    assert!((step.force - 0.25 * (0.5f64 / 20.0).sqrt()).abs() < 1e-7);
    assert!((step.sound - 0.4 * 0.5 / (10.0 * 1.05f64.powi(3) * 1.3)).abs() < 1e-7);
    assert!((step.speed - 0.1).abs() < 1e-7);
    assert_eq!(step.dt, step.sound);
    assert_eq!(TimeStep::new(&fluid, &extremes, 1e-4).dt, 1e-4);
}

#[test]
fn viscosity_acts_between_those_that_approach() {
    let fluid = fluid();
    assert_eq!(fluid.viscosity(0.3, 0.25, 20.0, 2000.0), 0.0);
    let expected = 2.0 * 0.5 * 0.5 * 10.0 / 2000.0 * 0.3 / (0.25 + 0.01 * 0.25);
    assert!((fluid.viscosity(-0.3, 0.25, 20.0, 2000.0) / expected - 1.0).abs() < 1e-6);
    let zeta = 0.5 * 0.3 / (0.25 + 0.01 * 0.25);
    let monaghan = Fluid { beta: 2.0, ..fluid }.viscosity(-0.3, 0.25, 20.0, 2000.0);
    assert!((monaghan / ((0.5 * 10.0 * zeta + 2.0 * zeta * zeta) / 1000.0) - 1.0).abs() < 1e-6);
}

#[test]
fn repulsion_is_continuous_and_ends() {
    // With h = 0.5: at q = 2/3 the rise is 2/3, at 1 it is 1/2, at 2 it is 0.
    let (fluid, h) = (fluid(), 0.5f32);
    let strength = |q: f32| fluid.repulsion((q * h).powi(2)) * (q * h).powi(2) / (0.01 * 100.0);
    for (q, rise) in [(0.3, 2.0 / 3.0), (2.0 / 3.0, 2.0 / 3.0), (1.0, 0.5), (1.5, 0.125), (2.0, 0.0), (2.5, 0.0)] {
        for beside in [q - 1e-4, q, q + 1e-4] {
            assert!((strength(beside) - rise).abs() < 3e-4, "{beside}: {}", strength(beside));
        }
    }
    assert!(fluid.repulsion(0.0).is_finite());
}

#[test]
fn scenes_are_checked() {
    let wrong = [
        ("kernel=\"cubik\"", "is no smoothing kernel; did you mean `cubic`?"),
        ("smoothing=0.1", "is not from 0.8 to 3"),
        ("extent=[0.001, 1.0]", "is not from 2 to 100000 spacings"),
        ("fluid.beta=1.0", "belongs to `viscosity = \"monaghan\"`"),
        ("sides.front=false", "is a side of `dimensions = 3`"),
        ("neighbours.most=2", "is not from 8 to 4096"),
        ("body.0.to=[0.4, 0.1143]", "outside the domain"),
        ("fluid.sound=0", "must be above zero"),
    ];
    let info = wcsph().scenes.iter().find(|scene| scene.name == "dam-break").unwrap();
    for (change, message) in wrong {
        let parsed = Scene::parse_with(info.text, "dam-break", Folder::BuiltIn, &[change.to_string()]);
        let error = parsed.and_then(|scene| scene.particles().map(|_| ())).unwrap_err().to_string();
        assert!(error.contains(message), "{change}: {error}");
    }
    let fixed = scene("dam-break", &["adaptive=false", "dt=1e-3"]);
    let error = (wcsph().build)(&fixed, "aos+lists").err().unwrap().to_string();
    assert!(error.contains("is unstable") && error.contains("adaptive = true"), "{error}");
    assert!(fixed.setup::<WcsphSetup>().unwrap().layers == 3);
}

/// Runs a scene's check; at least `count` findings, all of which pass.
fn passes(name: &str, overrides: &[&str], layout: &str, count: usize) {
    let scene = scene(name, overrides);
    let mut watch = wcsph().scenes.iter().find(|info| info.name == name).unwrap().gate.unwrap()(&scene).unwrap();
    let mut simulation = (wcsph().build)(&scene, layout).unwrap();
    watch.look(&*simulation);
    while simulation.time() < watch.until().unwrap() {
        simulation.step().unwrap();
        if simulation.steps().is_multiple_of(watch.every()) || simulation.time() >= watch.until().unwrap() {
            watch.look(&*simulation);
        }
    }
    let findings = watch.findings();
    assert!(findings.len() >= count, "{name} {overrides:?}: {} findings", findings.len());
    for finding in findings {
        assert!(finding.passes(), "{name} {overrides:?}, {layout}: {finding:?}");
    }
}

#[test]
fn a_drop_is_stretched_as_the_exact_solution() {
    passes("elliptical-drop", &[], "aos+lists", 6);
}
