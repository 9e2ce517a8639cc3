//! The solver's scenes: their checks, the same motion in every layout of the registry, and what is refused.

use allotrope::prelude::*;
use allotrope_solvers::mass_spring::{Integrator, Method, SpringsSetup};
use allotrope_solvers::scene::Folder;
use allotrope_solvers::{Scene, Simulation, SolverInfo, solver};

fn springs() -> &'static SolverInfo {
    solver("springs").unwrap()
}

fn scene(name: &str, overrides: &[&str]) -> Scene {
    let info = springs().scenes.iter().find(|scene| scene.name == name).unwrap();
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    Scene::parse_with(info.text, name, Folder::BuiltIn, &overrides).unwrap()
}

fn build(scene: &Scene, layout: &str) -> Box<dyn Simulation> {
    (springs().build)(scene, layout).unwrap()
}

fn layouts(scene: &Scene) -> Vec<&'static str> {
    let names = springs().layouts.iter().map(|layout| layout.name);
    names.filter(|layout| (springs().unfit)(scene, layout).is_none()).collect()
}

/// At least `count` findings, all of which pass.
fn passes(name: &str, overrides: &[&str], layout: &str, count: usize) {
    let info = springs().scenes.iter().find(|scene| scene.name == name).unwrap();
    let scene = scene(name, overrides);
    let mut watch = info.gate.unwrap()(&scene).unwrap();
    let mut simulation = build(&scene, layout);
    watch.look(&*simulation);
    while simulation.steps() < watch.steps() {
        simulation.step().unwrap();
        if simulation.steps() == watch.steps() || simulation.steps().is_multiple_of(watch.every()) {
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
fn checks_of_small_scenes_pass_in_all_layouts() {
    for (name, count) in [("three-points", 3), ("pendulum", 2), ("chain", 2)] {
        for layout in layouts(&scene(name, &[])) {
            passes(name, &[], layout, count);
        }
    }
}

#[test]
fn the_check_of_a_cloth_passes() {
    passes("cloth", &["sheet.0.masses=[24, 24]", "sheet.0.mass=3e-4"], "aos+rows", 3);
}

#[test]
fn all_layouts_of_the_registry_agree() {
    let small = ["sheet.0.masses=[12, 12]", "sheet.0.mass=1e-3"];
    for integrator in ["symplectic-euler", "backward-euler", "implicit-midpoint"] {
        let own = format!("integrator={integrator}");
        let scene = scene("cloth", &[&small[..], &[&own]].concat());
        assert_eq!(layouts(&scene).len(), springs().layouts.len());
        let mut expected: Option<Vec<[f64; 3]>> = None;
        for layout in layouts(&scene) {
            let mut cloth = build(&scene, layout);
            let schedule = Schedule { threads: 2, grain: 16, ..Schedule::default() };
            schedule.run(|| (0..300).try_for_each(|_| cloth.step())).unwrap();
            let x = cloth.positions();
            let expected = expected.get_or_insert_with(|| x.clone());
            let apart =
                x.iter().flatten().zip(expected.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-9, "{layout}, {integrator}: {apart:e}");
            assert!((x[143][1] - 1.3).abs() > 1e-3, "it falls");
        }
    }
}

#[test]
fn a_dense_table_of_too_many_masses_is_left_out() {
    let cloth = scene("cloth", &[]);
    let why = (springs().unfit)(&cloth, "aos+dense").unwrap();
    assert!(why.starts_with("too large"), "{why}");
    assert_eq!(layouts(&cloth).len(), springs().layouts.len() - 1);
    assert!((springs().unfit)(&scene("cloth", &["sheet.0.masses=[32, 64]", "dt=1e-5"]), "aos+dense").is_none());
    let fluid = solver("mpm").unwrap().scene("mpm88").unwrap();
    assert_eq!((springs().unfit)(&fluid, "aos+list"), Some("it is a scene of another solver"));
    assert!((springs().build)(&fluid, "aos+list").is_err());
}

#[test]
fn a_saved_run_goes_on_as_if_it_had_not_been_interrupted() {
    let scene = scene("three-points", &[]);
    let mut whole = build(&scene, "aos+rows");
    (0..300).for_each(|_| whole.step().unwrap());
    let mut first = build(&scene, "aos+rows");
    (0..120).for_each(|_| first.step().unwrap());
    let mut second = build(&scene, "aos+rows");
    second.restore(&first.save()).unwrap();
    assert_eq!((second.steps(), second.positions()), (120, first.positions()));
    (0..180).for_each(|_| second.step().unwrap());
    assert!(second.save() == whole.save());
    let mut cut = first.save();
    cut.arrays.pop();
    assert_eq!(second.restore(&cut).unwrap_err(), "array `velocity` is missing");
    assert!(second.save() == whole.save(), "nothing is changed");
}

#[test]
fn scenes_hold_what_they_say() {
    let points = scene("three-points", &[]);
    let setup: &SpringsSetup = points.setup().unwrap();
    assert_eq!((setup.masses.len(), setup.springs.len()), (3, 3));
    assert!(setup.springs.iter().all(|spring| spring.bond.rest == 0.1));
    let cloth =
        scene("cloth", &["integrator=backward-euler", "solve={method=\"jacobi\", damping=0.8, tolerance=1e-6}"]);
    let setup: &SpringsSetup = cloth.setup().unwrap();
    let n = 128;
    let springs = 2 * n * (n - 1) + 2 * (n - 1) * (n - 1) + 2 * n * (n - 2);
    assert_eq!((setup.masses.len(), setup.springs.len()), (n * n, springs));
    assert_eq!(setup.masses.iter().filter(|mass| mass.fixed).count(), 2);
    assert_eq!((setup.parameters.integrator, setup.parameters.method), (Integrator::Beta(1.0), Method::Jacobi(0.8)));
    let simulation = build(&cloth, "aos+list");
    assert_eq!((simulation.links().len(), simulation.particles()), (springs, n * n));
    assert_eq!(simulation.largest_dt(), None);
}

#[test]
fn what_is_wrong_in_a_scene_is_told_with_its_key() {
    const GOOD: &str = "version = 1\nsolver = \"springs\"\ndimensions = 2\nsize = [1, 1]\ndt = 1e-3\n\
                        [[mass]]\nposition = [0.1, 0.1]\n[[mass]]\nposition = [0.2, 0.1]\nmass = 2.0\n\
                        [[spring]]\nbetween = [0, 1]\nstiffness = 10.0\n";
    let read = |overrides: &[&str]| {
        let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
        Scene::parse_with(GOOD, "test", Folder::BuiltIn, &overrides)
            .and_then(|scene| (springs().build)(&scene, "aos+list").map(drop))
    };
    read(&[]).unwrap();
    for (wrong, told) in [
        ("size=[1, 0]", "`size = [1, 0]` must be above zero along each axis"),
        ("mass.0.mass=0", "`mass[0].mass = 0` must be above zero"),
        ("mass.0.masses=1", "`mass[0].masses` is not a key of a scene"),
        ("spring.0.between=[0, 2]", "`spring[0].between = [0, 2]` are not the numbers of two masses, from 0 to 1"),
        ("spring.0.between=[1, 1]", "`spring[0].between = [1, 1]` are not the numbers of two masses, from 0 to 1"),
        ("spring.0.stiffness=-1", "`spring[0].stiffness = -1` must be above zero"),
        ("integrator=euler", "`integrator = \"euler\"` is no integrator"),
        ("solve={method=\"gauss\"}", "`solve.method = \"gauss\"` is no method"),
        ("solve={damping=0.5}", "`solve.damping = 0.5` is for `method = \"jacobi\"`"),
        ("attractor={place=[0, 0]}", "`attractor.strength` is missing"),
        ("connect={stiffness=1}", "`connect.radius` is missing"),
        ("dt=1.0", "`dt = 1e0` is unstable: steps of 1e0 s are beyond the bound of stability, 5.164e-1 s; "),
        ("integrator=forward-euler", "`dt = 1e-3` is unstable: forward Euler is stable with no step"),
    ] {
        let error = read(&[wrong]).unwrap_err().to_string();
        assert!(error.contains(told), "{wrong}: {error}");
    }
    read(&["integrator=forward-euler", "unstable=true"]).unwrap();
    let twice = GOOD.to_string() + "[[spring]]\nbetween = [1, 0]\nstiffness = 1.0\n";
    let error = Scene::parse(&twice, "test", Folder::BuiltIn).unwrap_err().to_string();
    assert!(error.contains("spring 1 joins masses 1 and 0, which are joined already"), "{error}");
}
