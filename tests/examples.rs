//! What the examples compute. They are included as they stand, so that what is checked is what users read.

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/julia.rs"]
mod julia;

#[allow(dead_code, unreachable_pub, reason = "its `main` and the picture are for users")]
#[path = "../examples/mpm88.rs"]
mod mpm88;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/layouts_of_one_kernel.rs"]
mod layouts_of_one_kernel;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/mesh_to_particles.rs"]
mod mesh_to_particles;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/live_plot.rs"]
mod live_plot;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/game_of_life.rs"]
mod game_of_life;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/sparse_shell.rs"]
mod sparse_shell;

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/particle_lists.rs"]
mod particle_lists;

use std::fs;
use std::path::Path;

use allotrope::prelude::*;
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;

/// The counts agree with those of double precision: their sum within 50, which contraction of products may change, and
/// the number of points that never leave within 5.
#[test]
fn julia_counts() {
    fn check<L: Layout<Ij>>(t: f32, sum: u32, inside: usize, places: [([u32; 2], u32); 5]) {
        let counts = julia::counts::<L>(t);
        assert_eq!(counts.shape(), [640, 320]);
        assert!(counts.iter().sum::<u32>().abs_diff(sum) <= 50, "t = {t}: {}", counts.iter().sum::<u32>());
        let stayed = counts.iter().filter(|&count| count == 50).count();
        assert!(stayed.abs_diff(inside) <= 5, "t = {t}: {stayed}");
        for (at, count) in places {
            assert_eq!(counts.get(at), count, "t = {t}, {at:?}");
        }
    }
    for cpu in Cpu::ALL.into_iter().filter(|cpu| cpu.available()) {
        Schedule { cpu: Some(cpu), ..Schedule::default() }.run(|| {
            let at = [[0, 0], [320, 160], [160, 80], [200, 100], [400, 220]];
            let with = |counts: [u32; 5]| std::array::from_fn(|n| (at[n], counts[n]));
            check::<Aos>(0.0, 1_935_697, 2274, with([2, 17, 5, 6, 7]));
            check::<Blocked<8>>(0.03, 1_936_063, 2260, with([2, 17, 5, 6, 7]));
            check::<Aos>(1.0, 3_105_763, 45217, with([2, 50, 5, 7, 7]));
        });
    }
}

/// z² is even: turning the plane by half a turn maps the set onto itself.
#[test]
fn julia_is_symmetric() {
    let counts = julia::counts::<Aos>(0.03);
    let differ = (1..640).flat_map(|i| (1..320).map(move |j| (i, j)));
    let differ = differ.filter(|&(i, j)| counts.get((i, j)) != counts.get((640 - i, 320 - j))).count();
    assert_eq!(differ, 0);
}

#[test]
fn julia_writes_a_picture() {
    let folder = tempfile::tempdir().expect("a folder for the picture");
    let file = folder.path().join("julia.png");
    julia::draw(&julia::counts::<Aos>(0.0), &file).expect("the picture is written");
    let picture = image::open(&file).expect("the picture can be read").to_rgb8();
    assert_eq!(picture.dimensions(), (640, 320));
    // The corner, at the bottom left, took two of fifty iterations.
    assert_eq!(picture.get_pixel(0, 319).0, [114, 51, 10]);
}

/// The blocks fall freely until one touches the ground, stay in the tank, and mass on the grid is that of the points.
#[test]
fn mpm88_falls_and_stays_inside() {
    let mut points = mpm88::blocks::<Soa>();
    let mut grid = Field::<mpm88::Node, Aos>::new([128, 128]);
    let mean = |points: &Field<mpm88::Point, Soa>, of: fn(&mpm88::Point) -> f32| {
        points.iter().map(|point| f64::from(of(&point))).sum::<f64>() / points.len() as f64
    };
    let start = mean(&points, |point| point.x.y);
    for _ in 0..100 {
        mpm88::step(&mut points, &mut grid);
    }
    // 0.02 s: v = -1 - g t, and the height by the sum of the steps.
    let (t, g, dt) = (0.02, 9.8, 2e-4);
    assert!((mean(&points, |point| point.v.y) - (-1.0 - g * t)).abs() < 1e-3);
    assert!((mean(&points, |point| point.x.y) - (start - t - 0.5 * g * t * (t + dt))).abs() < 1e-4);
    let mass: f64 = grid.iter().map(|node| f64::from(node.m)).sum();
    assert!((mass - 8192.0 * 0.25 / (128.0 * 128.0)).abs() < 1e-6, "{mass}");
    for _ in 0..1200 {
        mpm88::step(&mut points, &mut grid);
    }
    // 0.26 s: both would be below the ground by now if it did not bear them.
    let height = mean(&points, |point| point.x.y);
    assert!((0.08..0.15).contains(&height), "{height}");
    let inside = |point: mpm88::Point| point.x.cmpge(Vec2::splat(0.01)).all() && point.x.cmple(Vec2::splat(0.99)).all();
    assert!(points.iter().all(inside));
}

/// The detector counts what plain Rust counts, photon for photon: times eight is exact, so that contracted products are
/// too.
#[test]
fn layouts_of_one_kernel_count_every_photon() {
    use layouts_of_one_kernel::{PIXELS, YEARS, catalogue, expose};
    let stars = catalogue(3001);
    let mut wanted = vec![0; PIXELS * PIXELS];
    let mut crossed = 0;
    for star in stars.iter() {
        let [x, y] = (star.position + YEARS * star.motion).to_array().map(|place| {
            crossed += usize::from(!(0.0..1.0).contains(&place));
            ((place - place.floor()) * PIXELS as f32) as usize
        });
        wanted[x.min(PIXELS - 1) * PIXELS + y.min(PIXELS - 1)] += star.photons;
    }
    assert!(crossed > 100, "{crossed} cross the border");
    let mut detector = Field::<u32, Blocked<8>>::new([PIXELS, PIXELS]);
    for _ in 0..2 {
        expose(&stars, &mut detector, YEARS);
        assert!(detector.iter().eq(wanted.iter().copied()));
    }
}

#[test]
fn layouts_of_one_kernel_draws_a_bar_for_each() {
    let folder = tempfile::tempdir().expect("a folder for the chart");
    let results = layouts_of_one_kernel::compare(4096, 2).expect("all layouts see the same");
    assert_eq!(results.timings.len(), 7);
    assert!(results.timings.iter().all(|timing| timing.samples.len() == 2 && timing.median() > 0.0));
    assert_eq!(results.table().lines().count(), 4 + 1 + 7);
    let chart = layouts_of_one_kernel::draw(&results, folder.path()).expect("the chart is written");
    let svg = fs::read_to_string(chart).expect("the chart can be read");
    let width = |line: &str| line.split_once(" width=\"")?.1.split('"').next()?.parse::<f64>().ok();
    let widths: Vec<f64> = svg.lines().filter(|line| line.starts_with("<rect")).filter_map(width).collect();
    assert_eq!(widths.len(), 1 + 7, "the paper and the bars: {svg}");
    // A pixel of the longest bar's some hundreds.
    let times: Vec<f64> = results.timings.iter().map(|timing| timing.median()).collect();
    for (width, time) in widths[1..].iter().zip(&times) {
        assert!(
            (width / widths[1] * times[0] / time - 1.0).abs() < 1.0 / width + 1.0 / widths[1],
            "{widths:?} {times:?}"
        );
    }
    for timing in &results.timings {
        assert!(svg.contains(&format!("\n{}\n", timing.name)), "{svg}");
    }
}

/// Moments of a lattice in a box, in closed form: n points a distance h apart have the variance h² (n² - 1) / 12.
#[test]
fn mesh_to_particles_weighs_a_box() {
    use mesh_to_particles::{fill, picture, read, weigh, write};
    let folder = tempfile::tempdir().expect("a folder for the files");
    let file = folder.path().join("box.obj");
    let corners = (0..8).map(|n| format!("v {} {} {}\n", 5 + (n & 1), 2 * (n >> 1 & 1) - 1, 3 * (n >> 2)));
    let faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"].map(|face| format!("f {face}\n"));
    fs::write(&file, corners.chain(faces).collect::<String>()).expect("the mesh is written");
    let mesh = read(&file).expect("the mesh is closed");

    let h = 0.125;
    let mut points = fill::<AoSoA<8>>(&mesh, h);
    assert_eq!(points.len(), 8 * 16 * 24);
    let body = weigh(&mut points, h.powi(3));
    let close = |a: DVec3, b: DVec3| assert!(a.abs_diff_eq(b, 1e-9), "{a} {b}");
    let (size, centre) = (dvec3(1.0, 2.0, 3.0), dvec3(5.5, 0.0, 1.5));
    assert_eq!((body.volume, mesh.volume()), (6.0, 6.0));
    close(body.centre, centre);
    close(body.bounds[0], centre - 0.5 * (size - h));
    close(body.bounds[1], centre + 0.5 * (size - h));
    let variance = (size * size - h * h) / 12.0;
    close(body.inertia.diagonal(), 6.0 * (DVec3::splat(variance.element_sum()) - variance));
    for axis in 0..3 {
        assert!(body.inertia.col(axis)[(axis + 1) % 3].abs() < 1e-9);
    }

    let drawn = picture(&points, &body, h);
    write(&points, &drawn, folder.path()).expect("the files are written");
    let png = image::open(folder.path().join("mesh_to_particles.png")).expect("the picture can be read").to_rgb8();
    assert!(png.dimensions() == (640, 640) && *png.as_raw() == drawn.rgb);
    // From the middles of the outer balls 90 % of the side are filled, and their radius beyond.
    let scale = 0.9 * 640.0 / (2.0 - h);
    let wanted = (scale * (2.0 + 0.5 * h)) * (scale * (1.0 + 0.5 * h));
    let covered = png.pixels().filter(|pixel| pixel.0 != [11, 15, 26]).count() as f64;
    assert!((covered / wanted - 1.0).abs() < 0.03, "{covered} {wanted}");

    let ply = fs::read(folder.path().join("mesh_to_particles.ply")).expect("the particles can be read");
    let end = ply.windows(11).position(|bytes| bytes == b"end_header\n").expect("a header") + 11;
    let header = String::from_utf8_lossy(&ply[..end]);
    let properties: Vec<&str> = header.lines().filter_map(|line| line.strip_prefix("property ")).collect();
    assert_eq!(properties, ["float x", "float y", "float z", "float distance"]);
    assert!(header.starts_with("ply\nformat binary_little_endian 1.0\n") && header.contains("\nelement vertex 3072\n"));
    let numbers: Vec<f32> = ply[end..].as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
    assert_eq!(numbers.len(), 4 * points.len());
    for (numbers, point) in numbers.chunks(4).zip(points.iter()) {
        let arm = DVec3::from_array([numbers[0], numbers[1], numbers[2]].map(f64::from)) - centre;
        assert_eq!(numbers[..3], point.position.as_vec3().to_array());
        assert!((f64::from(numbers[3]) - arm.length()).abs() < 1e-6);
    }
}

/// The bunny's points agree with the integrals over the tetrahedra between its triangles and the origin.
#[test]
fn mesh_to_particles_agrees_with_the_mesh() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("solvers/scenes/bunny.obj");
    let mesh = mesh_to_particles::read(&file).expect("the bunny is closed");
    let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
    let outer = |a: DVec3| DMat3::from_cols(a.x * a, a.y * a, a.z * a);
    for corners in mesh.corners() {
        let [a, b, c] = corners.map(DVec3::from_array);
        let (six_fold, sum) = (a.dot(b.cross(c)), a + b + c);
        volume += six_fold / 6.0;
        first += six_fold / 24.0 * sum;
        second += six_fold / 120.0 * (outer(a) + outer(b) + outer(c) + outer(sum));
    }
    let centre = first / volume;
    second -= volume * outer(centre);
    let inertia = DMat3::from_diagonal(DVec3::splat(second.diagonal().element_sum())) - second;

    let spacing = (volume / 50_000.0).cbrt();
    let mut points = mesh_to_particles::fill::<Soa>(&mesh, spacing);
    let body = mesh_to_particles::weigh(&mut points, spacing.powi(3));
    assert!((body.volume / volume - 1.0).abs() < 0.005, "{} {volume}", body.volume);
    assert!(body.centre.distance(centre) < 0.1 * spacing, "{} {centre}", body.centre);
    let largest = inertia.diagonal().max_element();
    for axis in 0..3 {
        let error = (body.inertia.col(axis) - inertia.col(axis)).abs().max_element();
        assert!(error < 0.005 * largest, "{} {inertia}", body.inertia);
    }
    let (low, high) = mesh.bounds();
    for (corner, wanted) in body.bounds.into_iter().zip([low, high]) {
        assert!((corner - DVec3::from_array(wanted)).abs().max_element() < 2.0 * spacing, "{corner} {wanted:?}");
    }
}

#[test]
fn mesh_to_particles_says_what_is_wrong_with_a_mesh() {
    let folder = tempfile::tempdir().expect("a folder for the mesh");
    let file = folder.path().join("open.obj");
    let message = |file: &Path| mesh_to_particles::read(file).expect_err("no mesh").to_string();
    assert!(message(&file).starts_with(&format!("`{}` cannot be read: ", file.display())));
    fs::write(&file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("the mesh is written");
    assert!(message(&file).starts_with(&format!("`{}` is not closed: 3 edges open", file.display())));
}

/// Without coral, a wave of food is an eigenvector of the step: it decays by a factor that is known.
#[test]
fn live_plot_spreads_as_waves_do() {
    use live_plot::{Dish, FEED, SPREAD, step};
    let shape = [33, 49];
    let phase = |at: [usize; 2], axis: usize, waves: f64| {
        (waves * std::f64::consts::PI * at[axis] as f64 / (shape[axis] - 1) as f64).sin()
    };
    let wave = |at: [usize; 2]| 0.25 * phase(at, 0, 2.0) * phase(at, 1, 3.0);
    let places = || (0..shape[0]).flat_map(|i| (0..shape[1]).map(move |j| [i, j]));
    let mut old = Field::<Dish, Split>::new(shape);
    for at in places() {
        old.set(at.map(|n| n as u32), Dish { food: 1.0 + wave(at) as f32, coral: 0.0 });
    }
    let mut new = old.clone();
    for _ in 0..20 {
        step(&old, &mut new);
        std::mem::swap(&mut old, &mut new);
    }
    let cosine = |axis: usize, waves: f64| (waves * std::f64::consts::PI / (shape[axis] - 1) as f64).cos();
    let rate = f64::from(FEED) + f64::from(SPREAD.food) * (4.0 - 2.0 * cosine(0, 2.0) - 2.0 * cosine(1, 3.0));
    let decayed = (1.0 - rate).powi(20);
    assert!((0.1..0.5).contains(&decayed), "{decayed}");
    for at in places() {
        let Dish { food, coral } = old.get(at.map(|n| n as u32));
        assert!((f64::from(food) - 1.0 - decayed * wave(at)).abs() < 2e-6 && coral == 0.0, "{at:?} {food}");
    }
}

/// Chemicals react as in double precision and plain Rust.
#[test]
fn live_plot_reacts() {
    use live_plot::{DEATH, Dish, FEED, SPREAD, dish, step};
    let [rows, columns] = [48, 64];
    let mut old = dish::<Aos>([rows, columns]);
    let mut plain: Vec<[f64; 2]> = old.iter().map(|cell| [cell.food, cell.coral].map(f64::from)).collect();
    let mut new = old.clone();
    let (feed, death) = (f64::from(FEED), f64::from(DEATH));
    for _ in 0..40 {
        step(&old, &mut new);
        std::mem::swap(&mut old, &mut new);
        let before = plain.clone();
        for cell in (0..rows * columns).filter(|n| (1..rows - 1).contains(&(n / columns))) {
            if !(1..columns - 1).contains(&(cell % columns)) {
                continue;
            }
            let [food, coral] = before[cell];
            let around = |c: usize| {
                [cell - 1, cell + 1, cell - columns, cell + columns]
                    .iter()
                    .map(|&n| before[n][c] - before[cell][c])
                    .sum::<f64>()
            };
            let eaten = food * coral * coral;
            plain[cell][0] += f64::from(SPREAD.food) * around(0) - eaten + feed * (1.0 - food);
            plain[cell][1] += f64::from(SPREAD.coral) * around(1) + eaten - (feed + death) * coral;
        }
    }
    for (Dish { food, coral }, wanted) in old.iter().zip(&plain) {
        assert!((f64::from(food) - wanted[0]).abs() < 1e-5 && (f64::from(coral) - wanted[1]).abs() < 1e-5);
    }
    // Something is left that reacts.
    assert!(plain.iter().any(|[_, coral]| *coral > 0.1));
}

#[test]
fn live_plot_films_every_frame() {
    let folder = tempfile::tempdir().expect("a folder for the film");
    let (shape, file) = ([48, 64], folder.path().join("film.gif"));
    live_plot::film(shape, 10, 3, &file).expect("the film is written");
    let film = std::io::Cursor::new(fs::read(&file).expect("the film can be read"));
    let frames = GifDecoder::new(film).expect("a GIF").into_frames().collect_frames().expect("whole frames");
    assert_eq!(frames.len(), 10);
    assert!(frames.iter().all(|frame| frame.buffer().dimensions() == (64, 48)));
    assert!(frames.iter().all(|frame| frame.delay().numer_denom_ms() == (40, 1)));
    // The first has so few colours that each is kept: sea, reef, their edges, and the border.
    let dish = live_plot::dish::<Soa>(shape);
    let mut pixels = Field::<[u8; 3], Soa>::new(shape);
    let total = live_plot::colour(&dish, &mut pixels);
    let drawn: Vec<[u8; 3]> = frames[0].buffer().pixels().map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    assert!(pixels.iter().eq(drawn.iter().copied()));
    let coral: f32 = dish.iter().map(|cell| cell.coral).sum();
    assert!((total - coral).abs() < 1e-3, "{total} {coral}");
    // A cell in the sea, by its colour's own formula.
    assert_eq!(drawn[64 + 1], [0.03f32, 0.07, 0.16].map(|light| (255.0 * light) as u8));
    assert!(frames.windows(2).all(|pair| pair[0].buffer() != pair[1].buffer()), "something moves");
}

/// The gun is as in plain Rust, generation after generation, and its population the known one.
#[test]
fn game_of_life_is_that_of_plain_rust() {
    use std::collections::HashSet;
    let around = |(i, j): (i32, i32)| (-1..2).flat_map(move |a| (-1..2).map(move |b| (i + a, j + b)));
    let mut plain: HashSet<(i32, i32)> = game_of_life::gun().active_iter().map(|(at, _)| at.into()).collect();
    assert_eq!(plain.len(), 36);
    let (mut now, mut next) = (game_of_life::gun(), Field::<u8, game_of_life::Plane, Ij>::unbounded());
    for generation in 0..=300 {
        let cells: HashSet<(i32, i32)> = now.active_iter().map(|(at, _)| at.into()).collect();
        assert!(cells == plain, "generation {generation}");
        if generation % 30 == 0 {
            assert_eq!(cells.len(), game_of_life::population(generation));
        }
        game_of_life::step(&now, &mut next);
        std::mem::swap(&mut now, &mut next);
        let candidates: HashSet<(i32, i32)> = plain.iter().flat_map(|&cell| around(cell)).collect();
        plain = candidates
            .into_iter()
            .filter(|&cell| match around(cell).filter(|cell| plain.contains(cell)).count() {
                3 => true,
                4 => plain.contains(&cell),
                _ => false,
            })
            .collect();
    }
    let folder = tempfile::tempdir().expect("a folder for the picture");
    let file = folder.path().join("life.png");
    game_of_life::draw(&now, &file).expect("the picture is written");
    let bright = image::open(&file).expect("a picture").to_luma8().pixels().filter(|pixel| pixel.0[0] > 128).count();
    assert_eq!(
        bright,
        16 * now
            .active_iter()
            .filter(|(at, _)| at.cmpge(IVec2::splat(-20)).all() && at.cmplt(IVec2::splat(140)).all())
            .count()
    );
}

/// The band holds the cells that are near the surface and no others, wherever it goes, in the memory that it had.
#[test]
fn sparse_shell_follows_its_sphere() {
    use sparse_shell::{RADIUS, SIZE, WIDTH};
    let mut band = Field::<sparse_shell::Cell, sparse_shell::Band>::new([SIZE; 3]);
    let mut centre = Vec3::new(100.0, 128.0, 128.0);
    sparse_shell::fill(&mut band, centre);
    let (cells, bytes) = (band.active_len(), band.bytes());
    for _ in 0..30 {
        centre += vec3(0.7, 0.1, -0.1);
        sparse_shell::follow(&mut band, centre);
    }
    let distance = |at: IVec3| (at.as_vec3() - centre).length() - RADIUS;
    assert!(band.active_iter().all(|(at, cell)| cell.distance == distance(at) && cell.distance.abs() < WIDTH));
    let volume = 4.0 / 3.0 * std::f32::consts::PI * ((RADIUS + WIDTH).powi(3) - (RADIUS - WIDTH).powi(3));
    assert!((band.active_len() as f32 / volume - 1.0).abs() < 2e-3 && (cells as f32 / volume - 1.0).abs() < 2e-3);
    assert!(band.bytes() as f64 <= 1.1 * bytes as f64, "{} bytes, and {bytes} at first", band.bytes());
    sparse_shell::curve(&mut band);
    assert!(sparse_shell::error(&band) < 5e-3, "{}", sparse_shell::error(&band));
}

#[test]
fn particle_lists_hold_every_particle_and_find_its_neighbours() {
    let x = particle_lists::spiral(20_000);
    let all = x.to_vec();
    let mut cells = Field::<u32, particle_lists::Cells>::new([particle_lists::CELLS; 2]);
    let mut neighbours = Field::<u32, Soa>::new([20_000]);
    for _ in 0..2 {
        particle_lists::bin(&x, &mut cells);
        particle_lists::count(&x, &cells, &mut neighbours);
        let mut held: Vec<u32> = cells.active_iter().map(|(_, p)| p).collect();
        held.sort_unstable();
        assert!(held.into_iter().eq(0..20_000));
        assert!((0..20_000).step_by(131).all(|p| neighbours.get(p) == particle_lists::counted(&all, p)));
    }
}
