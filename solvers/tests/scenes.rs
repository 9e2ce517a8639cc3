//! Scenes: what is read from them, and how what is wrong is told.

#[path = "scenes/keys.rs"]
mod keys;
#[path = "scenes/refused.rs"]
mod refused;
#[path = "scenes/setups.rs"]
mod setups;
#[path = "scenes/sources.rs"]
mod sources;

use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::scene::{Folder, Reorder};
use allotrope_solvers::{Scene, solver};

const GOOD: &str = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = [64, 32]
length = 2.0
dt = 4e-4
gravity = [0, -9.8]

[material]
stiffness = 400
density = 1.5

[[body]]
shape = "box"
from = [0.5, 0.25]
to = [1.0, 0.5]

[[body]]
shape = "ball"
center = [1.5, 0.5]
radius = 0.2
velocity = [0.0, -2.0]
spin = 3.0
"#;

fn parse(text: &str) -> Result<Scene, String> {
    Scene::parse(text, "test.toml", Folder::Path(env!("CARGO_TARGET_TMPDIR").into())).map_err(|error| error.to_string())
}

/// What a scene has beside what all scenes have.
fn own(scene: &Scene) -> &MpmSetup {
    scene.setup().unwrap()
}

/// The fault of the good scene in which a piece is replaced: on reading, on filling or on building.
fn fault(piece: &str, by: &str) -> String {
    assert!(GOOD.contains(piece), "{piece}");
    let message = match parse(&GOOD.replace(piece, by)) {
        Err(message) => message,
        Ok(scene) => match (solver("mpm").unwrap().build)(&scene, "aos+row") {
            Err(error) => error.to_string(),
            Ok(_) => panic!("`{by}` was not refused"),
        },
    };
    assert_eq!(message.lines().count(), 1, "{message}");
    message
}

#[test]
fn a_scene_is_read() {
    let scene = parse(GOOD).unwrap();
    assert_eq!((own(&scene).grid, scene.dimensions, own(&scene).dx()), ([64, 32, 1], 2, 2.0 / 64.0));
    assert_eq!((own(&scene).spacing, own(&scene).wall, scene.reorder(), scene.steps), (0.5, 3, Reorder::Never, 1000));
    assert_eq!(scene.extent(), [2.0, 1.0, 0.0]);
    let particles = scene.particles().unwrap();
    // 0.5 x 0.25 at a spacing of 1/64, and a disk of radius 0.2 at the same.
    let disk = particles.x.len() - 32 * 16;
    assert!((disk as f64 / 4096.0 / (std::f64::consts::PI * 0.04) - 1.0).abs() < 0.02, "{disk}");
    assert_eq!(particles.x[0], [0.5 + 1.0 / 128.0, 0.25 + 1.0 / 128.0, 0.0]);
    // The disk moves and turns about its centre.
    let (x, v, c) = (particles.x[600], particles.v[600], particles.c[600]);
    assert!((v[0] + 3.0 * (x[1] - 0.5)).abs() < 1e-12 && (v[1] + 2.0 - 3.0 * (x[0] - 1.5)).abs() < 1e-12);
    assert_eq!(c, [[0.0, -3.0, 0.0], [3.0, 0.0, 0.0], [0.0; 3]]);
}

#[test]
fn particles_are_sorted_when_the_scene_says() {
    let reorder = |value: &str| parse(&format!("reorder = {value}\n{GOOD}")).map(|scene| scene.reorder());
    assert_eq!(reorder("0"), Ok(Reorder::Never));
    assert_eq!(reorder("32"), Ok(Reorder::Every(32)));
    assert_eq!(reorder("\"auto\""), Ok(Reorder::Decayed));
    let wrong = "`reorder = \"often\"` is no number of steps, 0 for never, or \"auto\"";
    assert_eq!(reorder("\"often\""), Err(format!("scene `test.toml`: {wrong}")));
}

#[test]
fn random_and_jittered_particles_are_the_same_every_time() {
    let random = GOOD.replace("to = [1.0, 0.5]", "to = [1.0, 0.5]\nparticles = 500\nseed = 7");
    let (a, b) = (parse(&random).unwrap().particles().unwrap(), parse(&random).unwrap().particles().unwrap());
    assert_eq!(a, b);
    assert!(a.x[..500].iter().all(|x| (0.5..1.0).contains(&x[0]) && (0.25..0.5).contains(&x[1])));
    let other = parse(&random.replace("seed = 7", "seed = 8")).unwrap().particles().unwrap();
    assert_ne!(a.x, other.x);
    // The generator's stream is part of what a scene means: it must not change with a library's version.
    assert_eq!(a.x[0].map(|x| (x * 1e6).round() / 1e6), FIRST_OF_SEED_7);

    let jittered =
        parse(&GOOD.replace("to = [1.0, 0.5]", "to = [1.0, 0.5]\njitter = 0.5")).unwrap().particles().unwrap();
    let regular = parse(GOOD).unwrap().particles().unwrap();
    let moved = |n: usize| (0..2).map(|axis| (jittered.x[n][axis] - regular.x[n][axis]).abs()).fold(0.0, f64::max);
    assert!((0..512).all(|n| moved(n) <= 0.25 / 64.0) && (0..512).any(|n| moved(n) > 0.2 / 64.0));
}

const FIRST_OF_SEED_7: [f64; 3] = [0.570002, 0.289449, 0.0];

#[test]
fn built_in_scenes_are_as_described() {
    let mpm = solver("mpm").unwrap();
    for info in mpm.scenes {
        let scene = mpm.scene(info.name).unwrap();
        assert_eq!(scene.about, info.about);
    }
    let mpm88 = mpm.scene("mpm88").unwrap();
    assert_eq!((own(&mpm88).grid, mpm88.particles().unwrap().x.len()), ([128, 128, 1], 8192));
    assert_eq!(own(&mpm88).particle_volume(), (0.5f64 / 128.0).powi(2));
    let bunny = mpm.scene("bunny").unwrap();
    let count = bunny.particles().unwrap().x.len() as f64;
    let volume = 194.288 * 0.05f64.powi(3);
    assert!((count * own(&bunny).particle_volume() / volume - 1.0).abs() < 0.01);
}

#[test]
fn other_sizes_keep_the_scene() {
    let mpm88 = || solver("mpm").unwrap().scene("mpm88").unwrap();
    let scene = mpm88().with_grid(256).unwrap().with_particles(10_001).unwrap();
    assert_eq!((own(&scene).grid, scene.dt), ([256, 256, 1], 1e-4));
    assert_eq!(scene.particles().unwrap().x.len(), 10_001);
    let lattice = parse(GOOD).unwrap().with_particles(2000).unwrap();
    assert!(lattice.particles().unwrap().x.len().abs_diff(2000) < 60);
    assert_eq!(own(&parse(GOOD).unwrap().with_grid(128).unwrap()).grid, [128, 64, 1]);

    let error = |scene: Result<Scene, _>| {
        scene.map(|_| ()).map_err(|error: allotrope_solvers::SceneError| error.to_string()).unwrap_err()
    };
    assert!(error(mpm88().with_grid(4)).starts_with("scene `mpm88`: `grid = 4` cannot be"));
    assert!(error(mpm88().with_grid(1 << 20)).ends_with("an axis takes from 10 to 32768 nodes"));
    assert!(error(mpm88().with_grid(1 << 15)).contains("has 1073741824 nodes, which take 12.00 GiB, and more than"));
    assert!(error(parse(GOOD).unwrap().with_particles(5)).contains("needs a spacing of"));
    assert!(error(mpm88().with_particles(usize::MAX)).contains("is not from 1 to"));
}

#[test]
fn files_of_points_and_meshes_are_found_beside_the_scene() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("three.txt"), "# x, y\n0.5, 0.5\n0.6 0.5 # a comment\n\n0.7\t0.25\n").unwrap();
    let text = |file: &str| {
        let (head, _) = GOOD.split_once("[[body]]").unwrap();
        format!("{head}[[body]]\nshape = \"points\"\nfile = \"{file}\"\n")
    };
    let scene = parse(&text("three.txt")).unwrap();
    assert_eq!(scene.particles().unwrap().x, [[0.5, 0.5, 0.0], [0.6, 0.5, 0.0], [0.7, 0.25, 0.0]]);
    assert!(scene.with_particles(9).unwrap_err().to_string().contains("one by one"));

    std::fs::write(folder.join("empty.txt"), "# nothing yet\n").unwrap();
    let empty = parse(&text("empty.txt")).unwrap().particles().unwrap_err().to_string();
    assert!(empty.contains("`body[0]` holds no particle; make it larger"), "{empty}");

    std::fs::write(folder.join("bad.txt"), "0.5 0.5\n0.5 x\n").unwrap();
    assert!(
        parse(&text("bad.txt"))
            .unwrap_err()
            .contains("`body[0].file = \"bad.txt\"` has on line 2 `0.5 x`, where 2 finite")
    );
    assert!(parse(&text("none.txt")).unwrap_err().contains("`body[0].file = \"none.txt\"` cannot be read"));

    std::fs::write(folder.join("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let mesh = text("open.obj").replace("points", "mesh");
    assert!(parse(&mesh).unwrap_err().contains("`body[0].shape = \"mesh\"` needs `dimensions = 3`"));
    let mesh =
        mesh.replace("dimensions = 2", "dimensions = 3").replace("[64, 32]", "32").replace("[0, -9.8]", "[0, -9.8, 0]");
    let message = parse(&mesh).unwrap_err();
    assert!(
        message.contains("`body[0].file = \"open.obj\"` is not closed: 3 edges open")
            && message.contains("from (0, 0, 0)"),
        "{message}"
    );
}

#[test]
fn faults_name_file_key_and_value() {
    let cases = [
        ("version = 1", "version = 2", "`version = 2` must be there and 1"),
        ("version = 1", "", "`version` must be there"),
        ("dt = 4e-4", "", "`dt` is missing; write, for example, `dt = 2e-4`"),
        ("dt = 4e-4", "dt = -1", "`dt = -1` must be above zero"),
        ("dt = 4e-4", "dt = nan", "`dt = nan` is not a finite number"),
        ("dt = 4e-4", "dt = \"fast\"", "`dt = \"fast\"` is a text, where a number is wanted"),
        ("dt = 4e-4", "dt = 4e-300", "is out of range"),
        ("dt = 4e-4", "dt = 0.01", "`dt = 1e-2` is unstable: with sound at 16.3299, particles at up to"),
        ("length = 2.0", "lenght = 2.0", "`lenght` is not a key of a scene; did you mean `length`?"),
        ("density = 1.5", "density = -1.5", "`material.density = -1.5` must be above zero"),
        ("density = 1.5", "mass = 1.5", "`material.mass` is not a key of a scene; known are `stiffness`, `density`"),
        ("stiffness = 400", "stiffness = 0", "`material.stiffness = 0` must be above zero"),
        (
            "[material]\nstiffness = 400\ndensity = 1.5",
            "material = 3",
            "`material = 3` is a whole number, where a table",
        ),
        ("grid = [64, 32]", "grid = [64, 32, 32]", "holds 3 extents, where 2 are wanted"),
        ("grid = [64, 32]", "grid = 9", "`grid = 9` holds 9, which is not from 10 to 32768"),
        ("grid = [64, 32]", "grid = 64.5", "`grid = 64.5` is a number, where a whole number is wanted"),
        ("dimensions = 2", "dimensions = 4", "`dimensions = 4` holds 4, which is not from 2 to 3"),
        ("gravity = [0, -9.8]", "gravity = -9.8", "`gravity = -9.8` is a number, where a list of 2 numbers is wanted"),
        ("gravity = [0, -9.8]", "gravity = [0, inf]", "is not a finite number"),
        ("gravity = [0, -9.8]", "spacing = 0", "`spacing = 0` must be above zero"),
        ("gravity = [0, -9.8]", "spacing = 1.5", "`spacing = 1.5` is not from 0.05 to 1 cell"),
        ("gravity = [0, -9.8]", "wall = 2", "`wall = 2` holds 2, which is not from 3 to 64"),
        ("shape = \"ball\"", "shape = \"bal\"", "`body[1].shape = \"bal\"` is no shape; did you mean `ball`?"),
        ("radius = 0.2", "radius = 0.2\nseed = 3", "`body[1].seed = 3` is not a key of a body of the shape `ball`"),
        ("radius = 0.2", "raduis = 0.2", "`body[1].raduis` is not a key of a scene; did you mean `radius`?"),
        ("spin = 3.0", "spin = [0, 0, 3]", "`body[1].spin = [0, 0, 3]` is a list, where a number is wanted"),
        ("to = [1.0, 0.5]", "to = [0.4, 0.5]", "`body[0].to = [0.4, 0.5]` must lie above `from`"),
        ("to = [1.0, 0.5]", "to = [2.5, 0.5]", "`body[0]` puts particle"),
        ("to = [1.0, 0.5]", "to = [1.0, 0.5]\njitter = 2", "`body[0].jitter = 2` is not from 0 to 1"),
        ("to = [1.0, 0.5]", "to = [1.0, 0.5]\nparticles = 0", "`body[0].particles = 0` holds 0"),
        (
            "to = [1.0, 0.5]",
            "to = [1.0, 0.5]\nparticles = 1\njitter = 1",
            "`body[0].jitter = 1` moves particles of a lattice",
        ),
        ("radius = 0.2", "radius = -0.2", "`body[1].radius = -0.2` must be above zero"),
        ("dt = 4e-4", "dt = = 4e-4", "line 7 is not TOML"),
    ];
    for (piece, by, wanted) in cases {
        let message = fault(piece, by);
        assert!(
            message.starts_with("scene `test.toml`: ") && message.contains(wanted),
            "{by}\n  gives {message}\n  wanted {wanted}"
        );
    }
}

#[test]
fn the_domain_is_told_to_who_leaves_it() {
    let message = fault("to = [1.0, 0.5]", "to = [2.5, 0.5]");
    assert!(
        message.contains("outside the domain, which reaches from 0.0156 on each axis to (1.9531, 0.9531)"),
        "{message}"
    );
}
