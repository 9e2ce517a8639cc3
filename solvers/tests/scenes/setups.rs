//! What a solver's scenes have beside what all scenes have.

use std::sync::Arc;

use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::scene::{Particles, Reorder};
use allotrope_solvers::{Scene, SceneError, Setup, solver};

use super::{GOOD, own, parse};

/// A setup that has no more than it must have.
#[derive(Clone, Debug)]
struct Dots;

impl Setup for Dots {
    fn extent(&self) -> [f64; 3] {
        [1.0, 2.0, 0.0]
    }

    fn particles(&self, _scene: &Scene) -> Result<Particles, SceneError> {
        Ok(Particles::default())
    }
}

#[test]
fn a_setup_is_had_in_its_own_type_and_changed_for_its_scene_alone() {
    let scene = parse(GOOD).unwrap();
    let mut other = scene.clone();
    other.setup_mut::<MpmSetup>().unwrap().wall = 5;
    assert_eq!((own(&scene).wall, own(&other).wall), (3, 5));
    let message = "scene `test.toml`: is for the solver `mpm`";
    assert_eq!(scene.setup::<Dots>().unwrap_err().to_string(), message);
    assert_eq!(other.setup_mut::<Dots>().unwrap_err().to_string(), message);
}

#[test]
fn what_a_setup_cannot_be_is_told() {
    let scene = Scene { setup: Arc::new(Dots), solver: "dots".into(), ..parse(GOOD).unwrap() };
    assert_eq!((scene.extent(), scene.reorder()), ([1.0, 2.0, 0.0], Reorder::Never));
    let refused = |scene: Result<Scene, SceneError>| scene.map(|_| ()).unwrap_err().to_string();
    assert_eq!(
        refused(scene.clone().with_grid(64)),
        "scene `test.toml`: `grid = 64` cannot be, since the solver `dots` has no grid"
    );
    assert_eq!(
        refused(scene.clone().with_particles(64)),
        "scene `test.toml`: `particles = 64` cannot be, since the solver `dots` has as many particles as its scenes tell"
    );
    assert_eq!(
        refused(scene.clone().with_reorder(Reorder::Every(8))),
        "scene `test.toml`: `reorder = 8` cannot be, since the solver `dots` sorts nothing"
    );
    assert!(scene.clone().with_reorder(Reorder::Never).is_ok());
    let mpm = solver("mpm").unwrap();
    assert_eq!((mpm.unfit)(&scene, "aos+row"), Some("it is a scene of another solver"));
    let message = (mpm.build)(&scene, "aos+row").map(|_| ()).unwrap_err().to_string();
    assert_eq!(message, "scene `test.toml`: is for the solver `dots`");
}
