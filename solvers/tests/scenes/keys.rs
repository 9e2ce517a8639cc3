//! What each key means.

use allotrope_solvers::mpm::materials::{Elastic, Model, Sand, Snow};
use allotrope_solvers::mpm::{Forces, Scheme, Spline, Transfer};
use allotrope_solvers::scene::{CameraPlace, ColliderShape, Contact, Fill, Shape, Wall};
use allotrope_solvers::{Scene, solver};

use super::{GOOD, own, parse};

const MATERIAL: &str = "[material]\nstiffness = 400\ndensity = 1.5";

fn with(piece: &str, by: &str) -> Scene {
    assert!(GOOD.contains(piece), "{piece}");
    parse(&GOOD.replace(piece, by)).unwrap()
}

fn with_more(tables: &str) -> Scene {
    parse(&format!("{GOOD}\n{tables}")).unwrap()
}

/// The good scene in space.
fn space(tables: &str) -> Result<Scene, String> {
    let (head, _) = GOOD.split_once("[[body]]").unwrap();
    let head = head.replace("dimensions = 2", "dimensions = 3").replace("[64, 32]", "32").replace("-9.8]", "-9.8, 0]");
    parse(&format!("{head}\n[[body]]\nshape = \"ball\"\ncenter = [1, 1, 1]\nradius = 0.2\n{tables}"))
}

#[test]
fn materials_are_read() {
    let scene = with(
        MATERIAL,
        "[[material]]\nname = \"water\"\nstiffness = 400\ndensity = 1000\n\
         [[material]]\nname = \"rubber\"\nmodel = \"neo-hookean\"\nyoung = 1e5\npoisson = 0.25\ndensity = 900\n\
         [[material]]\nname = \"jelly\"\nmodel = \"corotated\"\nyoung = 1e4\npoisson = -0.25\ndensity = 800\n\
         [[material]]\nname = \"drift\"\nmodel = \"snow\"\nyoung = 1.4e5\npoisson = 0.2\ndensity = 400\n\
         [[material]]\nname = \"ice\"\nmodel = \"snow\"\nyoung = 1.4e5\npoisson = 0.2\ndensity = 900\nhardening = 5\n\
         compression = 0.019\nstretch = 5e-3\n\
         [[material]]\nname = \"beach\"\nmodel = \"sand\"\nyoung = 3.5e5\npoisson = 0.3\ndensity = 1600\n\
         [[material]]\nname = \"dune\"\nmodel = \"sand\"\nyoung = 3.5e5\npoisson = 0.3\ndensity = 1600\n\
         friction_angles = [30, 0, 0, 0]\nvolume_correction = false",
    );
    let names: Vec<_> = own(&scene).materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["water", "rubber", "jelly", "drift", "ice", "beach", "dune"]);
    let densities: Vec<_> = own(&scene).materials.iter().map(|material| material.density).collect();
    assert_eq!(densities, [1000.0, 900.0, 800.0, 400.0, 900.0, 1600.0, 1600.0]);
    let models: Vec<_> = own(&scene).materials.iter().map(|material| material.model).collect();
    let wanted = [
        Model::Fluid { stiffness: 400.0 },
        Model::NeoHookean(Elastic { mu: 4e4, lambda: 4e4 }),
        Model::Corotated(Elastic::new(1e4, -0.25)),
        Model::Snow(Snow::new(1.4e5, 0.2)),
        Model::Snow(Snow { hardening: 5.0, compression: 0.019, stretch: 5e-3, ..Snow::new(1.4e5, 0.2) }),
        Model::Sand(Sand::new(3.5e5, 0.3)),
        Model::Sand(Sand { friction: [30.0, 0.0, 0.0, 0.0], volume_correction: false, ..Sand::new(3.5e5, 0.3) }),
    ];
    assert_eq!(models, wanted);
    assert_eq!(Snow::new(1.0, 0.2).hardening, 10.0);
}

#[test]
fn a_lone_material_has_the_name_of_its_model_and_bodies_ask_by_name() {
    assert_eq!(own(&parse(GOOD).unwrap()).materials[0].name, "fluid");
    let sand = with(MATERIAL, "[material]\nmodel = \"sand\"\nyoung = 1e5\npoisson = 0.3\ndensity = 1");
    assert_eq!(own(&sand).materials[0].name, "sand");

    let two = "[[material]]\nname = \"a\"\nstiffness = 1\ndensity = 1\n\
               [[material]]\nname = \"b\"\nstiffness = 2\ndensity = 3";
    let text = GOOD.replace(MATERIAL, two).replace("spin = 3.0", "material = \"b\"");
    let particles = parse(&text).unwrap().particles().unwrap();
    assert!(particles.material[..512].iter().all(|&n| n == 0) && particles.material[512..].iter().all(|&n| n == 1));
    let unknown = parse(&text.replace("material = \"b\"", "material = \"steel\"")).unwrap_err();
    assert!(unknown.ends_with("`body[1].material = \"steel\"` is not the name of a material; known are `a`, `b`"));
}

#[test]
fn bodies_without_seeds_differ_and_follow_that_of_the_scene() {
    let body = "[[body]]\nshape = \"box\"\nfrom = [0.5, 0.25]\nto = [1.0, 0.5]\nparticles = 9\n";
    let (head, _) = GOOD.split_once("[[body]]").unwrap();
    let positions =
        |seed: &str, bodies: &str| parse(&format!("{seed}\n{head}{bodies}")).unwrap().particles().unwrap().x;
    let none = positions("", &body.repeat(2));
    assert_ne!(none[..9], none[9..]);
    // Body `n` has the scene's seed and `n`.
    assert_eq!(none, positions("", &format!("{body}seed = 0\n{body}seed = 1\n")));
    let seven = positions("seed = 7", &body.repeat(2));
    assert_eq!(seven, positions("", &format!("{body}seed = 7\n{body}seed = 8\n")));
    assert_eq!(parse(&format!("seed = 7\n{GOOD}")).unwrap().seed, 7);
    let jittered = body.replace("particles = 9", "jitter = 1");
    assert_ne!(positions("seed = 1", &jittered), positions("seed = 2", &jittered));
}

#[test]
fn aligned_particles_lie_in_every_cell_alike() {
    let scene = with("radius = 0.2", "radius = 0.2\naligned = true");
    let text = GOOD.replace("to = [1.0, 0.5]", "to = [1.01, 0.49]\naligned = true");
    assert!(matches!(own(&parse(&text).unwrap()).bodies[0].shape, Shape::Box { fill: Fill::Aligned, .. }));
    let boxed = parse(&text).unwrap().particles().unwrap();
    let half = own(&scene).dx() / 4.0;
    let disk = scene.particles().unwrap();
    for x in disk.x[512..].iter().chain(&boxed.x[..480]) {
        for component in &x[..2] {
            let odd = component / half;
            assert!((odd - odd.round()).abs() < 1e-9 && odd.round() as i64 % 2 == 1, "{x:?}");
        }
    }
    // From 0.5 to 1.01 in 33 columns, the last of which is at 1.0078; from 0.25 to 0.49 in 15 rows, to 0.4766 alone.
    assert_eq!(boxed.x.len() - (parse(GOOD).unwrap().particles().unwrap().x.len() - 512), 33 * 15);
    let exact = (0..128).flat_map(|i| (0..64).map(move |j| [i, j].map(|n| (f64::from(n) + 0.5) / 64.0)));
    let within = exact.filter(|[x, y]| (x - 1.5).powi(2) + (y - 0.5).powi(2) <= 0.2f64.powi(2)).count();
    assert_eq!(disk.x.len() - 512, within);
}

#[test]
fn transfers_are_read() {
    let read = |table: &str| own(&with_more(&format!("[transfer]\n{table}"))).transfer;
    assert_eq!(own(&parse(GOOD).unwrap()).transfer, Transfer::default());
    assert_eq!(read(""), Transfer::default());
    let quadratic = |scheme| Transfer { scheme, ..Transfer::default() };
    assert_eq!(read("scheme = \"pic\""), quadratic(Scheme::Pic));
    assert_eq!(read("scheme = \"flip\""), quadratic(Scheme::Flip { blend: 0.95 }));
    assert_eq!(read("scheme = \"flip\"\nblend = 1"), quadratic(Scheme::Flip { blend: 1.0 }));
    assert_eq!(read("scheme = \"polypic\""), quadratic(Scheme::PolyPic { modes: 9 }));
    assert_eq!(read("scheme = \"polypic\"\nmodes = 6"), quadratic(Scheme::PolyPic { modes: 6 }));
    let cubic = Transfer { scheme: Scheme::Apic, spline: Spline::Cubic, forces: Forces::Gradients };
    assert_eq!(read("scheme = \"apic\"\nspline = \"cubic\"\nforces = \"gradients\""), cubic);
    let linear = Transfer { scheme: Scheme::Pic, spline: Spline::Linear, forces: Forces::Gradients };
    assert_eq!(read("scheme = \"pic\"\nspline = \"linear\""), linear);
    let modes = |modes: &str| {
        space(&format!("[transfer]\nscheme = \"polypic\"\n{modes}")).map(|scene| own(&scene).transfer.scheme)
    };
    assert_eq!(modes(""), Ok(Scheme::PolyPic { modes: 27 }));
    assert_eq!(modes("modes = 8"), Ok(Scheme::PolyPic { modes: 8 }));
    assert!(modes("modes = 9").unwrap_err().ends_with("cannot be; in 3D it is one of 1, 4, 8, 11, 27"));
}

#[test]
fn walls_are_read_and_single_ones_overrule_all() {
    let separate = |friction| Contact::Separate { friction };
    assert_eq!(own(&parse(GOOD).unwrap()).walls, [[Wall::default(); 2]; 3]);
    let scene = with_more(
        "[walls]\nfriction = 0.25\n[walls.left]\ncontact = \"slip\"\n[walls.floor]\nvelocity = [2, 0]\n\
         [walls.ceiling]\ncontact = \"sticky\"\nvelocity = [-1, 0]\n[walls.right]\nfriction = 0.5",
    );
    let walls = own(&scene).walls;
    let still = |contact| Wall { contact, velocity: [0.0; 3] };
    assert_eq!(walls[0], [still(Contact::Slip), still(separate(0.5))]);
    let floor = Wall { contact: separate(0.25), velocity: [2.0, 0.0, 0.0] };
    assert_eq!(walls[1], [floor, Wall { contact: Contact::Sticky, velocity: [-1.0, 0.0, 0.0] }]);

    // What moves all walls must move none out of its plane.
    let text = "[walls]\nvelocity = [0, 0, 3]\n[walls.back]\nvelocity = [1, 1, 0]\n[walls.front]\n";
    assert!(space(text).unwrap_err().contains("`walls.velocity = [0, 0, 3]` would move the wall `front`"));
    let walls = own(&space(&format!("{text}velocity = [0, 0, 0]")).unwrap()).walls;
    assert_eq!(walls.map(|sides| sides.map(|wall| wall.velocity[2])), [[3.0; 2], [3.0; 2], [0.0; 2]]);
    assert_eq!(walls[2][0].velocity, [1.0, 1.0, 0.0]);
}

#[test]
fn colliders_are_read() {
    let scene = with_more(
        "[[collider]]\nshape = \"ball\"\ncenter = [1, 0.25]\nradius = 0.1\ncontact = \"sticky\"\n\
         [[collider]]\nshape = \"box\"\nfrom = [1, 0.25]\nto = [1.5, 0.5]\ncontact = \"slip\"\nvelocity = [1, 2]\n\
         [[collider]]\nshape = \"half-space\"\npoint = [1, 0.25]\nnormal = [-3e-200, 4e-200]\nfriction = 0.5",
    );
    let [ball, block, slope] = &own(&scene).colliders[..] else { panic!("{:?}", own(&scene).colliders) };
    assert!(matches!(ball.shape, ColliderShape::Ball { center: [1.0, 0.25, 0.0], radius: 0.1 }));
    assert_eq!((ball.contact, ball.velocity), (Contact::Sticky, [0.0; 3]));
    assert!(matches!(block.shape, ColliderShape::Box { from: [1.0, 0.25, 0.0], to: [1.5, 0.5, 0.0] }));
    assert_eq!((block.contact, block.velocity), (Contact::Slip, [1.0, 2.0, 0.0]));
    let ColliderShape::HalfSpace { point, normal } = slope.shape else { panic!("{slope:?}") };
    assert_eq!(point, [1.0, 0.25, 0.0]);
    assert!((normal[0] + 0.6).abs() < 1e-15 && (normal[1] - 0.8).abs() < 1e-15 && normal[2] == 0.0);
    assert_eq!(slope.contact, Contact::Separate { friction: 0.5 });

    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("collider.obj"), include_bytes!("../../scenes/bunny.obj")).unwrap();
    let mesh = "[[collider]]\nshape = \"mesh\"\nfile = \"collider.obj\"\nscale = 0.05\nmove = [1, 1, 1]";
    let scene = space(mesh).unwrap();
    let ColliderShape::Mesh(mesh) = &own(&scene).colliders[0].shape else { panic!("{:?}", own(&scene).colliders) };
    assert!((mesh.volume() - 194.288 * 0.05f64.powi(3)).abs() < 1e-6);
}

#[test]
fn the_camera_is_read() {
    assert_eq!(space("").unwrap().camera, CameraPlace::default());
    let camera = space("[camera]\nazimuth = -400\nelevation = 88.5\nzoom = 2").unwrap().camera;
    assert_eq!(camera, CameraPlace { azimuth: -400.0, elevation: 88.5, zoom: 2.0 });
    let fault = |text: &str| space(text).unwrap_err();
    assert!(
        fault("[camera]\nelevation = 89")
            .ends_with("`camera.elevation = 89` is not between -89 and 89 degrees, where up and down are seen")
    );
    assert!(fault("[camera]\nzoom = 0").contains("`camera.zoom = 0` must be above zero"));
    assert!(
        fault("[camera]\nazimut = 0").ends_with("`camera.azimut` is not a key of a scene; did you mean `azimuth`?")
    );
}

#[test]
fn a_particles_nodes_must_lie_in_the_grid_whatever_the_spline() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (head, _) = GOOD.split_once("[[body]]").unwrap();
    let head = head.replace("length = 2.0", "length = 64.0");
    let at = |spline: &str, x: f64| {
        let name = format!("at_{spline}_{x}.txt");
        std::fs::write(folder.join(&name), format!("{x} 9\n9 {}\n", x.min(31.0))).unwrap();
        let transfer = format!("[transfer]\nscheme = \"pic\"\nspline = \"{spline}\"");
        let scene = parse(&format!("{head}[[body]]\nshape = \"points\"\nfile = \"{name}\"\n{transfer}\n")).unwrap();
        scene.particles().map(|_| ()).map_err(|error| error.to_string())
    };
    // The lowest and the highest place, on axes of 64 and 32 cells of a metre.
    for (spline, low, high) in [("linear", 0.0, 63.0), ("quadratic", 0.5, 62.5), ("cubic", 1.0, 62.0)] {
        assert_eq!(at(spline, low), Ok(()), "{spline}");
        assert!(at(spline, low - 0.001).unwrap_err().contains("`body[0]` puts particle 0 at"), "{spline}");
        let message = at(spline, high).unwrap_err();
        let domain = format!("which reaches from {low:.4} on each axis to ({high:.4}, {:.4})", high - 32.0);
        assert!(message.contains("puts particle 0 at") && message.ends_with(&domain), "{message}");
        // The first axis' bound is met; on the second the particle is too far.
        assert!(at(spline, high - 0.001).unwrap_err().contains("puts particle 1 at (9.000000, 31.0"), "{spline}");
    }
    assert_eq!(own(&with_more("[transfer]\nspline = \"cubic\"")).wall, 4);
}

#[test]
fn what_does_not_fit_into_memory_is_refused_with_its_size() {
    // 9 words a particle, its number and start; 3 words a node.
    let scene = parse(GOOD).unwrap();
    assert_eq!(own(&scene).estimated_bytes(1000), 1000 * (36 + 4 + 124) + 64 * 32 * 12);
    let flip = with_more("[transfer]\nscheme = \"flip\"");
    assert_eq!(own(&flip).estimated_bytes(1), 4 * (2 + 1 + 1 + 4 + 4 + 2 + 2) + 128 + 64 * 32 * 20);
    let solid = with(MATERIAL, "[material]\nmodel = \"corotated\"\nyoung = 1\npoisson = 0\ndensity = 1");
    assert_eq!(
        own(&solid).estimated_bytes(1) - own(&solid).estimated_bytes(0),
        4 * (2 + 1 + 1 + 4 + 4 + 2 + 2 + 4) + 128
    );
    let polypic = space("[transfer]\nscheme = \"polypic\"").unwrap();
    assert_eq!(own(&polypic).estimated_bytes(1), 4 * (3 + 1 + 1 + 9 + 9 + 2 + 81) + 128 + 32 * 32 * 32 * 16);

    let large = parse(&GOOD.replace("[64, 32]", "[16384, 8192]")).unwrap();
    let gibibyte = 1 << 30;
    assert_eq!(own(&large).check_memory(&large, 1 << 24, 5 * gibibyte), Ok(()));
    assert_eq!(
        own(&large).check_memory(&large, 1 << 24, gibibyte).unwrap_err().to_string(),
        "scene `test.toml`: `grid = 16384 x 8192` takes 1.50 GiB for its 134217728 nodes, and 1.00 GiB are available; \
         take a coarser grid"
    );
    assert_eq!(
        own(&large).check_memory(&large, 1 << 24, 3 * gibibyte).unwrap_err().to_string(),
        "scene `test.toml`: `body` makes 16777216 particles, which take 2.56 GiB beside the grid's 1.50 GiB, and 3.00 \
         GiB are available; make the bodies smaller or `spacing` larger"
    );
    let message = parse(&GOOD.replace("[64, 32]", "32768")).unwrap_err();
    assert_eq!(
        message,
        "scene `test.toml`: `grid = 32768` has 1073741824 nodes, which take 12.00 GiB, and more than 268435456 (2^28) \
         are refused without `sparse = true`"
    );
}

#[test]
fn the_text_of_a_scene_is_the_scene_in_other_sizes_too() {
    let again = |scene: &Scene| {
        let again = Scene::parse(&scene.text, &scene.file, allotrope_solvers::scene::Folder::BuiltIn).unwrap();
        assert_eq!(again.text, scene.text);
        assert_eq!((own(&again).grid, again.dt, own(&again).spacing), (own(scene).grid, scene.dt, own(scene).spacing));
        assert_eq!(again.particles().unwrap(), scene.particles().unwrap());
    };
    for name in ["mpm88", "bunny"] {
        let scene = || solver("mpm").unwrap().scene(name).unwrap();
        again(&scene());
        again(&scene().with_grid(40).unwrap());
        again(&scene().with_grid(40).unwrap().with_particles(3001).unwrap());
    }
}

#[test]
fn differences_are_told_by_key_and_both_values() {
    let scene = parse(GOOD).unwrap();
    let difference = |piece: &str, by: &str| scene.difference(&with(piece, by).text);
    let told = |piece: &str, by: &str| difference(piece, by).expect(by);
    assert_eq!(scene.difference(&scene.text), None);
    assert_eq!(difference("length = 2.0", "length = 2\nsteps = 5\nabout = \"another\""), None);
    assert_eq!(told("dt = 4e-4", "dt = 2e-4\nseed = 3"), "`dt` is 0.0004 here and 0.0002 there");
    assert_eq!(told("dt = 4e-4", "dt = 4e-4\nseed = 3"), "`seed` is not given here and 3 there");
    assert_eq!(told("radius = 0.2", "radius = 0.1"), "`body[1].radius` is 0.2 here and 0.1 there");
    assert_eq!(told("from = [0.5,", "from = [0.4,"), "`body[0].from` is [0.5, 0.25] here and [0.4, 0.25] there");
    let third = "spin = 3.0\n[[body]]\nshape = \"points\"\nfile = \"third_body.txt\"";
    std::fs::write(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("third_body.txt"), "0.5 0.5\n").unwrap();
    let message = told("spin = 3.0", third);
    assert!(message.starts_with("`body[2]` is not given here and { file = \"third_body.txt\""), "{message}");
    assert_eq!(scene.difference("= no TOML"), Some("one of them is not TOML".into()));
}
