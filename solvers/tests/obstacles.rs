//! Walls and colliders: what they do to a node's velocity, and what a block does on a slope.

use allotrope::prelude::*;
use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::mpm::materials::{Elastic, Model};
use allotrope_solvers::mpm::obstacles::Obstacles;
use allotrope_solvers::scene::{Collider, ColliderShape, Contact, Folder, Scene, Wall};
use allotrope_solvers::{Simulation, solver};

const TEXT: &str = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = 32
length = 1.0
dt = 1e-4
material = { stiffness = 100.0, density = 1.0 }
body = [{ shape = "ball", center = [0.5, 0.5], radius = 0.1 }]
"#;

fn scene() -> Scene {
    Scene::parse(TEXT, "test", Folder::BuiltIn).unwrap()
}

/// What a scene has beside what all scenes have.
fn own(scene: &mut Scene) -> &mut MpmSetup {
    scene.setup_mut().unwrap()
}

/// What the floor makes of a velocity.
fn floor(contact: Contact, velocity: [f64; 3], v: Vec3) -> Vec3 {
    let mut scene = scene();
    own(&mut scene).walls[1][0] = Wall { contact, velocity };
    Obstacles::new(scene.setup().unwrap()).meet(ivec3(16, 1, 0), v)
}

#[test]
fn walls_do_what_they_are_named_after() {
    let (down, up) = (vec3(3.0, -2.0, 0.0), vec3(3.0, 2.0, 0.0));
    let rough = Contact::Separate { friction: 0.5 };
    let smooth = Contact::Separate { friction: 0.0 };
    let still = [0.0; 3];
    assert_eq!(floor(Contact::Sticky, still, up), Vec3::ZERO);
    assert_eq!(floor(Contact::Slip, still, up), vec3(3.0, 0.0, 0.0));
    assert_eq!(floor(smooth, still, up), up);
    assert_eq!(floor(smooth, still, down), vec3(3.0, 0.0, 0.0));
    // Coulomb: slowed by 0.5 times 2, and held where that is more than there is.
    assert_eq!(floor(rough, still, down), vec3(2.0, 0.0, 0.0));
    assert_eq!(floor(rough, still, vec3(0.9, -2.0, 0.0)), Vec3::ZERO);
    // A wall that moves takes along what sticks to it, and rubs relative to itself.
    assert_eq!(floor(Contact::Sticky, [1.0, 0.0, 0.0], down), Vec3::X);
    assert_eq!(floor(rough, [1.0, 0.0, 0.0], down), vec3(2.0, 0.0, 0.0));
    assert_eq!(floor(rough, [5.0, 0.0, 0.0], down), vec3(4.0, 0.0, 0.0));
}

#[test]
fn every_side_is_a_wall_and_the_inside_is_none() {
    let obstacles = Obstacles::new(scene().setup().unwrap());
    let v = vec3(-1.0, -1.0, 0.0);
    assert_eq!(obstacles.meet(ivec3(2, 16, 0), v), vec3(0.0, -1.0, 0.0));
    assert_eq!(obstacles.meet(ivec3(16, 2, 0), v), vec3(-1.0, 0.0, 0.0));
    assert_eq!(obstacles.meet(ivec3(30, 16, 0), -v), vec3(0.0, 1.0, 0.0));
    assert_eq!(obstacles.meet(ivec3(16, 30, 0), -v), vec3(1.0, 0.0, 0.0));
    assert_eq!(obstacles.meet(ivec3(1, 1, 0), v), Vec3::ZERO);
    assert_eq!(obstacles.meet(ivec3(3, 29, 0), v), v);
}

#[test]
fn colliders_hold_what_is_in_them_and_move() {
    let smooth = Contact::Separate { friction: 0.0 };
    let shapes = [
        (ColliderShape::Ball { center: [0.5, 0.5, 0.0], radius: 0.2 }, Vec3::Y),
        (ColliderShape::Box { from: [0.2, 0.4, 0.0], to: [0.8, 0.66, 0.0] }, Vec3::Y),
        (ColliderShape::HalfSpace { point: [0.0, 0.66, 0.0], normal: [0.0, 1.0, 0.0] }, Vec3::Y),
    ];
    for (shape, normal) in shapes {
        let mut scene = scene();
        own(&mut scene).colliders = vec![Collider { shape, contact: smooth, velocity: [0.0, 2.0, 0.0] }];
        let mut obstacles = Obstacles::new(scene.setup().unwrap());
        let node = ivec3(16, 20, 0);
        // Still at its place, but as fast as it moves.
        assert_eq!(obstacles.meet(node, -normal), 2.0 * normal);
        assert_eq!(obstacles.meet(node, 3.0 * normal), 3.0 * normal);
        assert_eq!(obstacles.meet(ivec3(16, 27, 0), -normal), -normal);
        obstacles.move_to(0.15);
        assert_eq!(obstacles.meet(ivec3(16, 27, 0), -normal), 2.0 * normal);
    }
}

/// The mean velocity along the slope of a block that slid for a while, and the time.
fn slide(degrees: f64, friction: f64) -> (f64, f64) {
    let mut scene = scene();
    let (sin, cos) = degrees.to_radians().sin_cos();
    scene.gravity = [9.8 * sin, -9.8 * cos, 0.0];
    own(&mut scene).materials[0].model = Model::Corotated(Elastic::new(2e3, 0.2));
    own(&mut scene).walls[1][0].contact = Contact::Separate { friction };
    own(&mut scene).bodies[0].shape = allotrope_solvers::scene::Shape::Box {
        from: [0.125, 0.09375, 0.0],
        to: [0.375, 0.15625, 0.0],
        fill: allotrope_solvers::scene::Fill::Lattice { jitter: 0.0, seed: 0 },
    };
    let mut block = (solver("mpm").unwrap().build)(&scene, "aos+row").unwrap();
    let mean = |block: &dyn Simulation| {
        let totals = block.totals();
        totals.momentum[0] / totals.mass
    };
    for _ in 0..500 {
        block.step().unwrap();
    }
    let before = mean(&*block);
    for _ in 0..2000 {
        block.step().unwrap();
    }
    (mean(&*block) - before, 0.2)
}

#[test]
fn a_block_slides_down_a_slope_as_coulomb_says() {
    for (degrees, friction) in [(30.0, 0.0), (30.0, 0.3), (20.0, 0.2)] {
        let (gained, time) = slide(degrees, friction);
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        let expected = 9.8 * (sin - friction * cos) * time;
        assert!((gained / expected - 1.0).abs() < 0.05, "{degrees} degrees, {friction}: {gained}, not {expected}");
    }
    // Steeper than the slope: it rests.
    let (gained, _) = slide(15.0, 0.5);
    assert!(gained.abs() < 0.01, "{gained}");
}
