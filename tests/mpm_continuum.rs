//! Every scene in every layout, and every transfer: equal results, equal bits where they are promised, states that go on.

mod support;

use allotrope::prelude::*;
use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::scene::Folder;
use allotrope_solvers::{Scene, Simulation, State, Values};
use support::*;

/// A built-in scene with some keys changed.
fn varied(name: &str, overrides: &[&str]) -> Scene {
    let info = mpm().scenes.iter().find(|scene| scene.name == name).unwrap();
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    Scene::parse_with(info.text, name, Folder::BuiltIn, &overrides).unwrap()
}

/// What a scene has beside what all scenes have.
fn setup(scene: &Scene) -> &MpmSetup {
    scene.setup().unwrap()
}

/// The layouts that make sense for a scene.
fn fit(scene: &Scene) -> Vec<&'static str> {
    layouts().filter(|layout| (mpm().unfit)(scene, layout).is_none()).collect()
}

/// The transfers that differ in records or kernels.
const TRANSFERS: [&[&str]; 9] = [
    &["transfer.scheme=pic"],
    &["transfer.scheme=flip", "transfer.blend=0.95"],
    &["transfer.scheme=flip", "transfer.spline=cubic"],
    &["transfer.scheme=pic", "transfer.spline=linear", "transfer.forces=gradients"],
    &["transfer.scheme=apic"],
    &["transfer.scheme=apic", "transfer.forces=gradients"],
    &["transfer.scheme=apic", "transfer.spline=cubic"],
    &["transfer.scheme=polypic", "transfer.modes=4"],
    &["transfer.scheme=polypic", "transfer.modes=3", "transfer.forces=gradients"],
];

fn agree(scene: &Scene, what: &str, steps: u64) {
    let mut first: Option<Vec<[f64; 3]>> = None;
    for layout in fit(scene) {
        let mut simulation = build(scene, layout);
        advance(&mut *simulation, Schedule::default(), steps);
        let positions = simulation.positions();
        assert!(positions.iter().flatten().all(|x| x.is_finite()), "{what}, {layout}");
        let moved = difference(&positions, &build(scene, layout).positions());
        assert!(moved > 1e-5, "{what}, {layout}: nothing moves");
        match &first {
            None => first = Some(positions),
            Some(first) => {
                let error = difference(&positions, first);
                assert!(error < 2e-6 * setup(scene).length, "{what}, {layout}: {error:.2e} from the first layout");
            }
        }
    }
}

#[test]
fn every_scene_runs_in_every_layout_with_equal_results() {
    for info in mpm().scenes {
        let scene = mpm().scene(info.name).unwrap();
        assert!(fit(&scene).len() >= if setup(&scene).sparse { 2 } else { 5 }, "{}", info.name);
        agree(&scene, info.name, if scene.dimensions == 2 { 60 } else { 12 });
    }
}

#[test]
fn every_transfer_runs_in_every_layout_with_equal_results() {
    for transfer in TRANSFERS {
        agree(&varied("disks", transfer), &format!("{transfer:?}"), 30);
        let small = [transfer, &["grid=[32, 24, 16]", "dt=4e-4"]].concat();
        let small: Vec<&str> =
            small.iter().map(|key| if *key == "transfer.modes=4" { "transfer.modes=8" } else { key }).collect();
        let small: Vec<&str> =
            small.iter().map(|key| if *key == "transfer.modes=3" { "transfer.modes=4" } else { key }).collect();
        agree(&varied("snowball", &small), &format!("{transfer:?} in space"), 8);
    }
}

#[test]
fn transfers_agree_with_each_other_on_a_block_that_moves_as_one() {
    // Free flight: whatever the transfer, momentum is kept and gravity does what it does.
    for transfer in TRANSFERS {
        let mut simulation = build(&varied("disks", &[transfer, &["gravity=[0.0, -1.0]"]].concat()), "aos+row");
        let start = simulation.totals();
        advance(&mut *simulation, Schedule::default(), 50);
        let (end, time) = (simulation.totals(), simulation.time());
        let fall = (end.momentum[1] - start.momentum[1]) / end.mass;
        assert!((fall + time).abs() < 1e-4 * time, "{transfer:?}: {fall} after {time} s");
        assert!((end.momentum[0] - start.momentum[0]).abs() < 1e-4 * end.mass * 0.1, "{transfer:?}: {end:?}");
    }
}

#[test]
fn flip_without_its_blend_is_pic_to_the_bit() {
    let positions = |overrides: &[&str]| {
        let mut simulation = build(&varied("spinning-disk", overrides), "soa+soa");
        let schedule = Schedule { deterministic: true, ..Schedule::default() };
        advance(&mut *simulation, schedule, 200);
        simulation.positions()
    };
    let pic = positions(&["transfer.scheme=pic"]);
    assert!(pic == positions(&["transfer.scheme=flip", "transfer.blend=0.0"]));
    assert!(pic != positions(&["transfer.scheme=flip", "transfer.blend=0.5"]));
}

#[test]
fn deterministic_runs_of_all_carriers_are_the_same_bits() {
    for transfer in
        [&["transfer.scheme=apic"][..], &["transfer.scheme=flip"], &["transfer.scheme=polypic", "transfer.modes=4"]]
    {
        let scene = varied("three-materials", transfer);
        let mut first: Option<State> = None;
        for cpu in instruction_sets() {
            for threads in [1, 2, 3] {
                let schedule = Schedule {
                    threads,
                    scatter: Scatter::Private,
                    deterministic: true,
                    cpu: Some(cpu),
                    ..Schedule::default()
                };
                let mut simulation = build(&scene, "soa+soa");
                advance(&mut *simulation, schedule, 30);
                let state = simulation.save();
                assert!(*first.get_or_insert_with(|| state.clone()) == state, "{transfer:?}, {cpu}, {threads} threads");
            }
        }
    }
}

#[test]
fn a_saved_state_goes_on_as_the_first_would_have() {
    let schedule = Schedule { deterministic: true, scatter: Scatter::Private, ..Schedule::default() };
    let scenes = [
        varied("mpm88", &["reorder=7"]),
        varied("bunny", &["grid=32", "dt=6e-4"]),
        varied("three-materials", &["reorder=\"auto\""]),
        varied("disks", &["transfer.scheme=flip", "reorder=5"]),
        varied("disks", &["transfer.scheme=polypic", "transfer.modes=4"]),
        varied("snowball", &["grid=[32, 24, 16]", "dt=4e-4"]),
    ];
    for scene in scenes {
        let grouped = fit(&scene).contains(&"aosoa16+blocked4");
        for layout in ["soa+soa", if grouped { "aosoa16+blocked4" } else { "aos+sparse4" }] {
            let mut first = build(&scene, layout);
            advance(&mut *first, schedule, 12);
            let state = first.save();
            let mut second = build(&scene, layout);
            second.restore(&state).unwrap();
            assert_eq!((second.save(), second.time()), (state.clone(), first.time()));
            advance(&mut *first, schedule, 20);
            advance(&mut *second, schedule, 20);
            assert!(first.save() == second.save(), "{}, {layout}", scene.file);
            assert!(first.positions() == second.positions(), "{}, {layout}", scene.file);
            refuses_what_does_not_fit(&mut *second, &state);
        }
    }
}

/// Whatever array is missing, short or wrong, the state is refused and nothing changes.
fn refuses_what_does_not_fit(simulation: &mut dyn Simulation, state: &State) {
    let before = simulation.save();
    for n in 0..state.arrays.len() {
        let mut missing = state.clone();
        let name = missing.arrays.remove(n).name;
        assert_eq!(simulation.restore(&missing), Err(format!("array `{name}` is missing")));
        let mut short = state.clone();
        match &mut short.arrays[n].values {
            Values::F32(values) => drop(values.pop()),
            Values::F64(values) => drop(values.pop()),
            Values::U32(values) => drop(values.pop()),
        }
        let error = simulation.restore(&short).unwrap_err();
        assert!(error.starts_with(&format!("array `{name}` holds ")), "{error}");
    }
    let mut twice = state.clone();
    for array in &mut twice.arrays {
        if let ("identity", Values::U32(values)) = (array.name, &mut array.values) {
            values[1] = values[0];
        }
    }
    assert_eq!(simulation.restore(&twice), Err("array `identity` does not name each particle once".into()));
    assert!(simulation.save() == before);
}

#[test]
fn sand_at_rest_stays_a_heap_and_snow_holds_together() {
    // A heap flatter than its angle of friction stays; a pool of water of the same shape would not.
    let slope = ["body.0.from=[0.2, 0.009375]", "body.0.to=[0.6, 0.034375]", "steps=3000"];
    let mut heap = build(&varied("sand-column", &slope), "aos+row");
    let width = |simulation: &dyn Simulation| {
        let along: Vec<f64> = simulation.positions().iter().map(|x| x[0]).collect();
        along.iter().copied().fold(0.0, f64::max) - along.iter().copied().fold(1.0, f64::min)
    };
    let start = width(&*heap);
    advance(&mut *heap, Schedule::default(), 3000);
    assert!(width(&*heap) < 1.12 * start, "{start} became {}", width(&*heap));
}

/// Water that falls upon a bunny of stone runs off it: no particle is deeper in it than one and a half cells.
#[test]
fn water_runs_off_a_mesh() {
    let overrides = [
        "body=[{ shape = \"box\", from = [0.3, 0.65, 0.35], to = [0.7, 0.85, 0.65] }]",
        "collider=[{ shape = \"mesh\", file = \"bunny.obj\", scale = 0.06, move = [0.5, 0.05, 0.5] }]",
        "grid=48",
        "dt=4e-4",
    ];
    let scene = varied("bunny", &overrides);
    let bunny = allotrope_solvers::mesh::read_obj(include_bytes!("../solvers/scenes/bunny.obj")).unwrap();
    let bunny = bunny.closed().unwrap().placed(0.06, [0.5, 0.05, 0.5]);
    let distance = allotrope_solvers::mesh::SignedDistance::new(&bunny, 0.01);
    let mut water = build(&scene, "soa+soa");
    let deepest = |water: &dyn Simulation| {
        let depths = water.positions().into_iter().filter_map(|x| distance.at(x)).map(|(distance, _)| -distance);
        depths.fold(0.0, f64::max)
    };
    let wet = |water: &dyn Simulation| {
        water.positions().into_iter().filter_map(|x| distance.at(x)).filter(|(distance, _)| *distance < 0.03).count()
    };
    assert_eq!(wet(&*water), 0);
    let mut touched = 0;
    for _ in 0..12 {
        advance(&mut *water, Schedule::default(), 100);
        assert!(deepest(&*water) < 1.5 * setup(&scene).dx(), "{} deep after {} steps", deepest(&*water), water.steps());
        touched = touched.max(wet(&*water));
    }
    assert!(touched > 500, "{touched}");
}

#[test]
fn memory_is_estimated_as_it_is_taken() {
    let scenes = mpm().scenes.iter().map(|info| mpm().scene(info.name).unwrap());
    let transfers = TRANSFERS.iter().map(|transfer| varied("disks", transfer));
    for scene in scenes.chain(transfers) {
        if setup(&scene).sparse {
            // How many nodes there are follows from where the particles are: within a factor.
            let mut simulation = build(&scene, "aos+hash4");
            advance(&mut *simulation, Schedule::default(), 1);
            let (estimated, taken) =
                (setup(&scene).estimated_bytes(simulation.particles()) as f64, simulation.bytes() as f64);
            assert!((1.0..4.0).contains(&(estimated / taken)), "{}: {estimated}, not {taken}", scene.file);
            continue;
        }
        let simulation = build(&scene, "aos+row");
        // Beside the fields, 128 bytes a particle with which it starts.
        let estimated =
            setup(&scene).estimated_bytes(simulation.particles()) as f64 - 128.0 * simulation.particles() as f64;
        let taken = simulation.bytes() as f64;
        assert!(
            (estimated / taken - 1.0).abs() < 0.02,
            "{} {:?}: {estimated}, not {taken}",
            scene.file,
            setup(&scene).transfer
        );
    }
}
