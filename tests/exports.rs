//! What the laboratory writes for other programs, read back by parsers that are written here; and what pictures show.

mod support;

use std::collections::HashMap;
use std::time::Duration;

use allotrope::Schedule;
use allotrope_lab::lab::export::{gif, mp4, npz, ply, sheet, vtk};
use allotrope_lab::lab::render::{Camera, Picture, Shading};
use allotrope_solvers::mpm::Material;
use allotrope_solvers::mpm::materials::{Elastic, Model};
use allotrope_solvers::scene::{Collider, ColliderShape, Contact};
use allotrope_solvers::{Array, Energy, Scene, Simulation, State, StepError, Totals, Values};
use image::AnimationDecoder;
use support::*;

const SMALL: &str = r#"
version = 1
solver = "mpm"
dimensions = 3
grid = [16, 20, 12]
length = 0.8
dt = 5e-4
gravity = [0.0, -9.8, 0.0]
material = { stiffness = 200.0, density = 3.0 }
body = [{ shape = "box", from = [0.2, 0.15, 0.2], to = [0.6, 0.5, 0.4], velocity = [0.5, 0.0, 0.25] }]
"#;

fn run(scene: &Scene, steps: u64) -> Box<dyn Simulation> {
    let mut simulation = build(scene, "soa+soa");
    advance(&mut *simulation, Schedule::default(), steps);
    simulation
}

/// A plane and a space after some steps.
fn simulations() -> [Box<dyn Simulation>; 2] {
    [run(&mpm88(), 50), run(&scene(SMALL), 20)]
}

fn word<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    bytes[at..at + N].try_into().unwrap()
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
}

fn wholes(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

/// The values of an array by name, three an element where it has two.
fn padded(arrays: &[Array], name: &str) -> Vec<f32> {
    let array = arrays.iter().find(|array| array.name == name).unwrap();
    let Values::F32(values) = &array.values else { panic!("{name} holds no floats") };
    match array.components {
        2 => values.chunks(2).flat_map(|vector| [vector[0], vector[1], 0.0]).collect(),
        _ => values.clone(),
    }
}

/// CRC-32, bit by bit.
fn sum_of(bytes: &[u8]) -> u32 {
    let step = |rest: u32, _| if rest & 1 == 1 { rest >> 1 ^ 0xedb8_8320 } else { rest >> 1 };
    !bytes.iter().fold(u32::MAX, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), step))
}

#[test]
fn arrays_come_back_from_npz() {
    for simulation in simulations() {
        let arrays = simulation.particle_arrays();
        let bytes = npz::write(&arrays, &[("about.json", "{\"step\": 50}")]).unwrap();
        let read = npz::read(&bytes).unwrap();
        let wanted: Vec<_> =
            arrays.iter().map(|array| (array.name.to_string(), array.components, array.values.clone())).collect();
        assert_eq!(read.arrays, wanted);
        assert_eq!(read.texts, [("about.json".to_string(), "{\"step\": 50}".to_string())]);

        // The members of the archive, as its format says where they are.
        let mut at = 0;
        for array in &arrays {
            assert_eq!(word(&bytes, at), *b"PK\x03\x04");
            assert_eq!(u16::from_le_bytes(word(&bytes, at + 8)), 0, "stored, not compressed");
            let size = u32::from_le_bytes(word(&bytes, at + 18)) as usize;
            let [name, extra] = [26, 28].map(|field| usize::from(u16::from_le_bytes(word(&bytes, at + field))));
            assert_eq!(bytes[at + 30..][..name], *format!("{}.npy", array.name).as_bytes());
            let member = &bytes[at + 30 + name + extra..][..size];
            assert_eq!(u32::from_le_bytes(word(&bytes, at + 14)), sum_of(member));
            assert_eq!(member[..8], *b"\x93NUMPY\x01\x00");
            let (header, data) = member[10..].split_at(usize::from(u16::from_le_bytes(word(member, 8))));
            assert!((10 + header.len()).is_multiple_of(64) && header.ends_with(b"\n"));
            let shape = match array.components {
                1 => format!("({},)", simulation.particles()),
                components => format!("({}, {components})", simulation.particles()),
            };
            let (kind, same) = match &array.values {
                Values::F32(values) => ("<f4", floats(data) == *values),
                Values::F64(values) => ("<f8", data == values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>()),
                Values::U32(values) => ("<u4", wholes(data) == *values),
            };
            let text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
            assert_eq!(std::str::from_utf8(header).unwrap().trim_end(), text);
            assert!(same, "{}", array.name);
            at += 30 + name + extra + size;
        }
    }
}

#[test]
fn an_npz_that_is_cut_off_is_refused() {
    let bytes = npz::write(&run(&scene(SMALL), 1).save().arrays, &[("about.json", "{}")]).unwrap();
    for tenth in 0..10 {
        let end = bytes.len() * tenth / 10;
        let message = npz::read(&bytes[..end]).unwrap_err();
        assert!(
            message.starts_with(&format!("is cut off, damaged or no `.npz` file at all ({end} bytes)")),
            "{message}"
        );
        assert_eq!(message.lines().count(), 1);
    }
}

#[test]
fn particles_come_back_from_ply() {
    for simulation in simulations() {
        let bytes = ply::particles(&*simulation);
        let end = b"end_header\n";
        let length = bytes.windows(end.len()).position(|piece| piece == end).unwrap() + end.len();
        let header: Vec<&str> = std::str::from_utf8(&bytes[..length]).unwrap().lines().collect();
        let (count, time) = (simulation.particles(), simulation.time());
        assert_eq!(header[..2], ["ply", "format binary_little_endian 1.0"]);
        assert_eq!(header[2], format!("comment step {}, time {time} s", simulation.steps()));
        assert_eq!(header[3], format!("element vertex {count}"));
        let properties: Vec<&str> = header.iter().filter_map(|line| line.strip_prefix("property ")).collect();
        let names = ["x", "y", "z", "vx", "vy", "vz", "pressure"].map(|name| format!("float {name}"));
        assert_eq!(properties[..7], names);
        assert_eq!(properties[7..], ["uint material"]);
        let data = &bytes[length..];
        assert_eq!(data.len(), 32 * count);
        let arrays = simulation.particle_arrays();
        let (x, v, p) = (padded(&arrays, "position"), padded(&arrays, "velocity"), padded(&arrays, "pressure"));
        for (n, record) in data.chunks(32).enumerate() {
            let wanted = [&x[3 * n..][..3], &v[3 * n..][..3], &[p[n]]].concat();
            assert_eq!(floats(&record[..28]), wanted, "particle {n}");
            assert_eq!(wholes(&record[28..]), [simulation.material_of()[n]]);
        }
    }
}

/// The XML of a VTK file, and what is appended to it.
fn vtk_parts(bytes: &[u8]) -> (String, &[u8]) {
    let mark = b"<AppendedData encoding=\"raw\">\n_";
    let at = bytes.windows(mark.len()).position(|piece| piece == mark).unwrap();
    let data = bytes[at + mark.len()..].strip_suffix(b"\n</AppendedData>\n</VTKFile>\n").unwrap();
    (String::from_utf8(bytes[..at].to_vec()).unwrap(), data)
}

fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
    let (_, rest) = element.split_once(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{name} is not in {element}"));
    rest.split_once('"').unwrap().0
}

/// Kind, components and bytes of each array by name.
fn vtk_arrays<'a>(xml: &str, data: &'a [u8]) -> HashMap<String, (String, usize, &'a [u8])> {
    let elements = xml.split('<').filter(|element| element.contains("format=\"appended\""));
    let arrays = elements.map(|element| {
        let offset: usize = attribute(element, "offset").parse().unwrap();
        let length = u64::from_le_bytes(word(data, offset)) as usize;
        let components = attribute(element, "NumberOfComponents").parse().unwrap();
        let name = attribute(element, "Name").to_string();
        (name, (attribute(element, "type").to_string(), components, &data[offset + 8..][..length]))
    });
    arrays.collect()
}

#[test]
fn particles_come_back_from_vtp() {
    for simulation in simulations() {
        let bytes = vtk::particles(&*simulation);
        let (xml, data) = vtk_parts(&bytes);
        let head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" \
                    header_type=\"UInt64\">\n";
        assert!(xml.starts_with(head), "{xml}");
        let piece = xml.split('<').find(|element| element.starts_with("Piece")).unwrap();
        let count = simulation.particles();
        assert_eq!(attribute(piece, "NumberOfPoints"), count.to_string());
        assert_eq!(attribute(piece, "NumberOfVerts"), count.to_string());
        assert!(xml.contains(&format!(">{}</DataArray>", simulation.time())), "{xml}");
        let arrays = vtk_arrays(&xml, data);
        let known = simulation.particle_arrays();
        for (name, components) in [("position", 3), ("velocity", 3), ("pressure", 1)] {
            let (kind, told, bytes) = &arrays[name];
            assert_eq!((kind.as_str(), *told), ("Float32", components));
            assert_eq!(floats(bytes), padded(&known, name), "{name}");
        }
        assert_eq!((arrays["material"].0.as_str(), wholes(arrays["material"].2)), ("UInt32", simulation.material_of()));
        assert_eq!(arrays.len(), known.len() + 2, "all arrays, and the vertices");
        assert_eq!(wholes(arrays["connectivity"].2), (0..count as u32).collect::<Vec<_>>());
        assert_eq!(wholes(arrays["offsets"].2), (1..=count as u32).collect::<Vec<_>>());
    }
}

#[test]
fn the_grid_comes_back_from_vti() {
    for simulation in simulations() {
        let bytes = vtk::grid(&*simulation);
        let (xml, data) = vtk_parts(&bytes);
        let mut shape = simulation.grid_shape();
        shape.resize(3, 1);
        let image = xml.split('<').find(|element| element.starts_with("ImageData")).unwrap();
        let [columns, rows, layers] = [shape[0], shape[1], shape[2]];
        let extent = format!("0 {} 0 {} 0 {}", columns - 1, rows - 1, layers - 1);
        assert_eq!(attribute(image, "WholeExtent"), extent);
        let cell: f64 = attribute(image, "Spacing").split(' ').next().unwrap().parse().unwrap();
        assert!((cell * columns as f64 / simulation.extent()[0] - 1.0).abs() < 1e-12);
        let arrays = vtk_arrays(&xml, data);
        let known = simulation.grid_arrays();
        assert_eq!(arrays.len(), known.len());
        let (mass, velocity) = (padded(&known, "mass"), padded(&known, "velocity"));
        let (told_mass, told_velocity) = (floats(arrays["mass"].2), floats(arrays["velocity"].2));
        assert_eq!((arrays["mass"].1, arrays["velocity"].1), (1, 3));
        assert_eq!((told_mass.len(), told_velocity.len()), (mass.len(), velocity.len()));
        let mut at = 0;
        for k in 0..layers {
            for j in 0..rows {
                for i in 0..columns {
                    let node = (i * rows + j) * layers + k;
                    assert_eq!(told_mass[at], mass[node], "node {i}, {j}, {k}");
                    assert_eq!(told_velocity[3 * at..][..3], velocity[3 * node..][..3], "node {i}, {j}, {k}");
                    at += 1;
                }
            }
        }
        // The mass lies about where the particles are, which have moved on by a step.
        let height = |at: usize| cell * (at / columns % rows) as f64;
        let total: f64 = told_mass.iter().map(|&mass| f64::from(mass)).sum();
        let mean = told_mass.iter().enumerate().map(|(at, &mass)| f64::from(mass) * height(at)).sum::<f64>() / total;
        let particles = simulation.positions().iter().map(|x| x[1]).sum::<f64>() / simulation.particles() as f64;
        assert!((mean - particles).abs() < 0.1 * cell, "{mean} and {particles}");
    }
}

#[test]
fn a_gif_holds_the_frames_of_a_run() {
    let scene = mpm88();
    let mut simulation = run(&scene, 0);
    let camera = Camera::new(&*simulation, &scene, Shading::fitting(&*simulation));
    let mut film = gif::Gif::new(Vec::new(), 400, 400, 20.0).unwrap();
    let mut pictures = Vec::new();
    for _ in 0..4 {
        let picture = camera.picture(&*simulation).halved();
        film.add(&picture).unwrap();
        pictures.push(picture);
        advance(&mut *simulation, Schedule::default(), 150);
    }
    let bytes = film.finish().unwrap();
    assert!(bytes.len() < 4 * 60_000, "{} bytes", bytes.len());
    let decoder = image::codecs::gif::GifDecoder::new(std::io::Cursor::new(&bytes)).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    assert_eq!(frames.len(), 4);
    for (n, (frame, picture)) in frames.iter().zip(&pictures).enumerate() {
        assert_eq!(frame.buffer().dimensions(), (400, 400));
        assert_eq!(frame.delay().numer_denom_ms(), (50, 1));
        let rgb: Vec<u8> = frame.buffer().pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        let off: f64 = rgb.iter().zip(&picture.rgb).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
        assert!(off / (rgb.len() as f64) < 1.5, "frame {n} is off by {} a component", off / rgb.len() as f64);
    }
}

#[test]
fn a_sheet_shows_twelve_of_many_pictures() {
    let scene = mpm88();
    let simulation = run(&scene, 3);
    assert_eq!(sheet::label(simulation.steps(), simulation.time()), "step 3  0.0006 s");
    let picture = Camera::new(&*simulation, &scene, Shading::Velocity).picture(&*simulation);
    let mut contact = sheet::Sheet::new(31);
    for number in 0..31 {
        contact.add(number, &picture, &sheet::label(simulation.steps(), simulation.time()));
    }
    let png = image::load_from_memory(&contact.png().unwrap()).unwrap();
    // Four columns and three rows of half pictures, and something between them.
    assert!((1600..1680).contains(&png.width()) && (1200..1340).contains(&png.height()), "{:?}", png.width());
}

#[test]
fn a_film_is_made_where_ffmpeg_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.mp4");
    for n in 0..3u8 {
        let picture = Picture { width: 63, height: 48, rgb: vec![80 * n; 63 * 48 * 3] };
        std::fs::write(folder.path().join(format!("frame_{n:04}.png")), picture.png().unwrap()).unwrap();
    }
    if !mp4::available() {
        println!("ffmpeg is not installed here: that this is told is all that is checked");
        let message = mp4::write(folder.path(), 2, 25.0, &path).unwrap_err().to_string();
        assert!(message.contains("`ffmpeg`, which makes films, is not installed"), "{message}");
        return;
    }
    mp4::write(folder.path(), 2, 25.0, &path).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    assert_eq!(bytes[4..8], *b"ftyp");
    assert!(bytes.windows(4).any(|piece| piece == b"avc1"), "the film is of H.264");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 4);
}

/// A simulation that says that its left half is of another material.
struct Halves(Box<dyn Simulation>);

impl Simulation for Halves {
    fn kernel_names(&self) -> &'static [&'static str] {
        self.0.kernel_names()
    }
    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        self.0.step_timed(spent)
    }
    fn steps(&self) -> u64 {
        self.0.steps()
    }
    fn dt(&self) -> f64 {
        self.0.dt()
    }
    fn dimensions(&self) -> usize {
        self.0.dimensions()
    }
    fn particles(&self) -> usize {
        self.0.particles()
    }
    fn grid_shape(&self) -> Vec<usize> {
        self.0.grid_shape()
    }
    fn extent(&self) -> [f64; 3] {
        self.0.extent()
    }
    fn margin(&self) -> f64 {
        self.0.margin()
    }
    fn spacing(&self) -> f64 {
        self.0.spacing()
    }
    fn bytes(&self) -> usize {
        self.0.bytes()
    }
    fn positions(&self) -> Vec<[f64; 3]> {
        self.0.positions()
    }
    fn velocities(&self) -> Vec<[f64; 3]> {
        self.0.velocities()
    }
    fn particle_arrays(&self) -> Vec<Array> {
        self.0.particle_arrays()
    }
    fn grid_arrays(&self) -> Vec<Array> {
        self.0.grid_arrays()
    }
    fn materials(&self) -> Vec<String> {
        vec!["water".into(), "jelly".into()]
    }
    fn material_of(&self) -> Vec<u32> {
        self.positions().iter().map(|x| u32::from(x[0] < 0.4)).collect()
    }
    fn pressures(&self) -> Vec<f64> {
        self.positions().iter().map(|x| if x[0] < 0.4 { 1e3 } else { -1e3 }).collect()
    }
    fn save(&self) -> State {
        self.0.save()
    }
    fn restore(&mut self, state: &State) -> Result<(), String> {
        self.0.restore(state)
    }
    fn energy(&self) -> Energy {
        self.0.energy()
    }
    fn totals(&self) -> Totals {
        self.0.totals()
    }
    fn time(&self) -> f64 {
        self.0.time()
    }
    fn grid_mass(&self) -> Option<f64> {
        self.0.grid_mass()
    }
}

/// The scene with two materials, and its simulation at the start.
fn halves(mut scene: Scene) -> (Scene, Halves) {
    let simulation = Halves(run(&scene, 0));
    let model = Model::Corotated(Elastic { mu: 1.0, lambda: 1.0 });
    own(&mut scene).materials[0].name = "water".into();
    own(&mut scene).materials.push(Material { name: "jelly".into(), density: 1.0, model });
    (scene, simulation)
}

fn pixel(picture: &Picture, column: usize, row: usize) -> [i32; 3] {
    picture.rgb.as_chunks::<3>().0[row * picture.width + column].map(i32::from)
}

/// How many pixels are how coloured.
fn count(picture: &Picture, is: impl Fn([i32; 3]) -> bool) -> usize {
    (0..picture.width * picture.height).filter(|&n| is(pixel(picture, n % picture.width, n / picture.width))).count()
}

#[test]
fn colours_tell_materials_and_pressures_apart() {
    let red = |[r, g, b]: [i32; 3]| r > g + 40 && r > b + 20 && r > 90;
    let blue = |[r, g, b]: [i32; 3]| b > r + 60 && b > g + 20 && b > 90;
    for plane in [mpm88(), scene(SMALL)] {
        let (scene, simulation) = halves(plane);
        assert_eq!(Shading::fitting(&simulation), Shading::Material);
        assert_eq!(Shading::fitting(&*simulation.0), Shading::Velocity);
        let shown = [Shading::Velocity, Shading::Material, Shading::Pressure]
            .map(|shading| Camera::new(&simulation, &scene, shading).picture(&simulation));
        let [velocity, material, pressure] =
            shown.each_ref().map(|picture| (count(picture, red), count(picture, blue)));
        assert!(velocity.0 < 100 && velocity.1 > 10_000, "velocity: {velocity:?}");
        for (name, (red, blue)) in [("material", material), ("pressure", pressure)] {
            assert!(red > 5_000 && blue > 5_000, "{name}: {red} red, {blue} blue");
        }
    }
}

#[test]
fn where_materials_meet_their_colours_mix() {
    let (scene, simulation) = halves(mpm88());
    let picture = Camera::new(&simulation, &scene, Shading::Material).picture(&simulation);
    // The body reaches from 0.2 to 0.6 in both directions.
    let mean = |columns: std::ops::Range<usize>| {
        let sums =
            columns.clone().flat_map(|column| (380..580).map(move |row| (column, row))).fold([0; 3], |sums, at| {
                let colour = pixel(&picture, at.0, at.1);
                std::array::from_fn(|c| sums[c] + colour[c])
            });
        sums.map(|sum: i32| sum / (200 * columns.len() as i32))
    };
    let [left, middle, right] = [mean(200..300), mean(319..321), mean(340..440)];
    assert!(left[0] > 180 && left[2] < 140 && right[0] < 80 && right[2] > 180, "{left:?} {right:?}");
    for c in [0, 2] {
        let (least, most) = (left[c].min(right[c]) + 20, left[c].max(right[c]) - 20);
        assert!((least..most).contains(&middle[c]), "{left:?} {middle:?} {right:?}");
    }
}

#[test]
fn colliders_are_seen_where_they_have_moved_to() {
    let mut scene = mpm88();
    let simulation = run(&scene, 100);
    let time = simulation.time();
    assert!((time - 0.02).abs() < 1e-12);
    let stands = |shape, velocity| Collider { shape, contact: Contact::Slip, velocity };
    own(&mut scene).colliders = vec![
        // 0.3 to the right in this time.
        stands(ColliderShape::Ball { center: [0.5, 0.8, 0.0], radius: 0.1 }, [15.0, 0.0, 0.0]),
        stands(ColliderShape::Box { from: [0.1, 0.7, 0.0], to: [0.3, 0.9, 0.0] }, [0.0; 3]),
        stands(ColliderShape::HalfSpace { point: [0.0, 0.1, 0.0], normal: [0.0, 1.0, 0.0] }, [0.0; 3]),
    ];
    let picture = Camera::new(&*simulation, &scene, Shading::Velocity).picture(&*simulation);
    let grey = |x: f64, y: f64| {
        let [r, g, b] = pixel(&picture, (800.0 * x) as usize, (800.0 * (1.0 - y)) as usize);
        r > 70 && (r - g).abs() < 20 && (g - b).abs() < 25
    };
    for (x, y) in [(0.8, 0.8), (0.72, 0.8), (0.8, 0.88), (0.2, 0.8), (0.11, 0.71), (0.5, 0.05), (0.95, 0.09)] {
        assert!(grey(x, y), "nothing stands at {x}, {y}");
    }
    for (x, y) in [(0.5, 0.8), (0.68, 0.8), (0.8, 0.68), (0.32, 0.8), (0.05, 0.5), (0.5, 0.11)] {
        assert!(!grey(x, y), "something stands at {x}, {y}");
    }
    // The rim is lighter than what it encloses.
    assert!(pixel(&picture, 81, 160)[0] > pixel(&picture, 160, 160)[0] + 40);
}

#[test]
fn colliders_in_space_hide_what_is_behind_them_and_are_hidden_before() {
    let bluish = |[r, _, b]: [i32; 3]| b > r + 60 && b > 100;
    let mut scene = scene(SMALL);
    let simulation = run(&scene, 0);
    let fluid = |scene: &Scene| {
        let picture = Camera::new(&*simulation, scene, Shading::Velocity).picture(&*simulation);
        (count(&picture, bluish), picture)
    };
    let (alone, before) = fluid(&scene);
    assert!(alone > 10_000, "{alone}");
    let cuboid = |from, to| {
        let shape = ColliderShape::Box { from, to };
        vec![Collider { shape, contact: Contact::Slip, velocity: [0.0; 3] }]
    };
    own(&mut scene).colliders = cuboid([0.1, 0.05, 0.5], [0.7, 0.9, 0.55]);
    assert!(fluid(&scene).0 < alone / 10, "a box in front hides the fluid: {} of {alone}", fluid(&scene).0);
    own(&mut scene).colliders = cuboid([0.3, 0.2, 0.1], [0.5, 0.3, 0.15]);
    assert!(fluid(&scene).0 > alone * 99 / 100, "a box behind does not: {} of {alone}", fluid(&scene).0);
    let mesh = "v 0.3 0.6 0.3\nv 0.5 0.6 0.3\nv 0.4 0.6 0.45\nv 0.4 0.8 0.35\nf 1 2 3\nf 2 1 4\nf 3 2 4\nf 1 3 4\n";
    let mesh = allotrope_solvers::mesh::read_obj(mesh.as_bytes()).unwrap().closed().unwrap();
    let shapes = [
        ColliderShape::Ball { center: [0.4, 0.7, 0.35], radius: 0.08 },
        ColliderShape::Mesh(mesh),
        ColliderShape::HalfSpace { point: [0.1, 0.1, 0.1], normal: [0.8, 0.6, 0.0] },
    ];
    for shape in shapes {
        own(&mut scene).colliders = vec![Collider { shape: shape.clone(), contact: Contact::Slip, velocity: [0.0; 3] }];
        let (_, picture) = fluid(&scene);
        let changed = picture.rgb.chunks(3).zip(before.rgb.chunks(3)).filter(|(a, b)| a != b).count();
        assert!((2_000..150_000).contains(&changed), "{shape:?} shows in {changed} pixels");
    }
}

#[test]
fn the_camera_stands_where_the_scene_says() {
    let mut scene = scene(SMALL);
    let simulation = run(&scene, 0);
    let fluid = |scene: &Scene| {
        let picture = Camera::new(&*simulation, scene, Shading::Velocity).picture(&*simulation);
        count(&picture, |[r, _, b]| b > r + 60 && b > 100) as f64
    };
    let usual = fluid(&scene);
    scene.camera.zoom = 1.3;
    let near = fluid(&scene) / usual;
    assert!((1.4..1.9).contains(&near), "1.3 times as near, {near} times as large");
    scene.camera.zoom = 1.0;
    // The box is twice as wide as it is deep: from its side less of it is seen; straight from above, something too.
    scene.camera.elevation = 0.0;
    scene.camera.azimuth = 0.0;
    let front = fluid(&scene);
    scene.camera.azimuth = 90.0;
    let side = fluid(&scene);
    assert!((0.3..0.75).contains(&(side / front)), "{side} of {front}");
    scene.camera.elevation = 90.0;
    assert!(fluid(&scene) > 0.3 * side);
}
