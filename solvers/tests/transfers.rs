//! What a round trip between particles and grid keeps, in each way to carry velocity.

use allotrope::prelude::*;
use allotrope_solvers::Scene;
use allotrope_solvers::mpm::continuum::{
    AffinePoint, ChangingNode, Node, PlainPoint, PolynomialPoint, Transfers, affine, plain, polynomial, quadratic,
};
use allotrope_solvers::mpm::{Forces, MpmSetup, Scheme, Spline, Transfer};
use allotrope_solvers::scene::Folder;

const TEXT: &str = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = 32
length = 1.0
dt = 2e-4
material = { stiffness = 100.0, density = 1.0 }
body = [{ shape = "ball", center = [0.5, 0.5], radius = 0.25 }]
"#;

fn scene(dimensions: usize, transfer: Transfer) -> Scene {
    let text = TEXT.replace("dimensions = 2", &format!("dimensions = {dimensions}"));
    let text = if dimensions == 3 { text.replace("[0.5, 0.5]", "[0.5, 0.5, 0.5]") } else { text };
    let mut scene = Scene::parse(&text, "test", Folder::BuiltIn).unwrap();
    scene.setup_mut::<MpmSetup>().unwrap().transfer = transfer;
    scene
}

/// The constants of a transfer in which nothing moves and nothing is deformed.
fn still(scheme: Scheme, spline: Spline) -> Transfers<Ij> {
    let forces = if spline == Spline::Linear { Forces::Gradients } else { Forces::LeastSquares };
    let scene = scene(2, Transfer { scheme, spline, forces });
    let mut mpm = Transfers::<Ij>::new(&scene, scene.setup().unwrap());
    (mpm.constants.dt, mpm.constants.impulse) = (0.0, 0.0);
    mpm
}

/// Four particles in each cell within a disk about the middle, at the same places in every cell.
fn disk(radius: f32) -> Vec<Vec2> {
    let at = |n: i32| (n as f32 + 0.5) / 64.0;
    let all = (0..64).flat_map(|i| (0..64).map(move |j| vec2(at(i), at(j))));
    all.filter(|x| x.distance(Vec2::splat(0.5)) < radius).collect()
}

/// A rotation of 2 rad/s about the middle.
fn rotation(x: Vec2) -> Vec2 {
    2.0 * vec2(0.5 - x.y, x.x - 0.5)
}

/// Angular momentum about the middle and kinetic energy, in `f64`, with what an affine field adds to both.
fn kept(points: impl Iterator<Item = (Vec2, Vec2, Mat2)>) -> (f64, f64) {
    points.fold((0.0, 0.0), |(momentum, energy), (x, v, c)| {
        let (arm, v, c) = ((x - 0.5).as_dvec2(), v.as_dvec2(), c.as_dmat2());
        let moment = 1.0 / (4.0 * 32.0 * 32.0);
        let affine = c.x_axis.length_squared() + c.y_axis.length_squared();
        (
            momentum + arm.perp_dot(v) + moment * (c.x_axis.y - c.y_axis.x),
            energy + 0.5 * (v.length_squared() + moment * affine),
        )
    })
}

#[test]
fn pic_loses_angular_momentum_as_published() {
    let (mpm, places) = (still(Scheme::Pic, Spline::Quadratic), disk(0.25));
    assert_eq!(places.len(), 812);
    let mut points = Field::<PlainPoint<Ij>, Soa>::new([places.len()]);
    for (p, &x) in places.iter().enumerate() {
        points.set(p, PlainPoint { x, v: rotation(x), mass: 1.0, ..Default::default() });
    }
    let mut grid = Field::<ChangingNode<Ij>, Aos>::new([32, 32]);
    let obstacles = allotrope_solvers::mpm::obstacles::Obstacles::new(scene(2, Transfer::default()).setup().unwrap());
    let of = |points: &Field<PlainPoint<Ij>, Soa>| kept(points.iter().map(|point| (point.x, point.v, Mat2::ZERO)));
    let start = of(&points);
    // Jiang et al. 2017, the transfers alone: numbers of an independent program in double precision.
    let table = [(1, 0.985430, 0.971387), (10, 0.870039, 0.761394), (100, 0.266867, 0.072105)];
    let mut cycles = 0;
    for (until, momentum, energy) in table {
        while cycles < until {
            plain::clear(&mut grid);
            plain::particle_to_grid(&points, &mut grid, &mpm);
            assert_eq!(plain::update_grid(&mut grid, &mpm, &obstacles), 0);
            plain::grid_to_particle(&mut points, &grid, &mpm);
            cycles += 1;
        }
        let now = of(&points);
        assert!((now.0 / start.0 - momentum).abs() < 2e-4, "{cycles} cycles: {} of L0", now.0 / start.0);
        assert!((now.1 / start.1 - energy).abs() < 2e-4, "{cycles} cycles: {} of K0", now.1 / start.1);
    }
}

/// One round trip of affine particles, by the kernels of any spline or by those of the usual one.
fn affine_trip(
    points: &mut Field<AffinePoint<Ij>, Soa>,
    grid: &mut Field<Node<Ij>, Aos, Ij>,
    mpm: &Transfers<Ij>,
    usual: bool,
) {
    let obstacles = allotrope_solvers::mpm::obstacles::Obstacles::new(scene(2, Transfer::default()).setup().unwrap());
    affine::clear(grid);
    if usual {
        quadratic::particle_to_grid(points, grid, mpm);
    } else {
        affine::particle_to_grid(points, grid, mpm);
    }
    affine::update_grid(grid, mpm, &obstacles);
    if usual {
        quadratic::grid_to_particle(points, grid, mpm);
    } else {
        affine::grid_to_particle(points, grid, mpm);
    }
}

#[test]
fn apic_keeps_angular_momentum_and_energy_of_a_rotation() {
    for (spline, usual) in [(Spline::Quadratic, true), (Spline::Quadratic, false)] {
        let (mpm, places) = (still(Scheme::Apic, spline), disk(0.25));
        let mut points = Field::<AffinePoint<Ij>, Soa>::new([places.len()]);
        for (p, &x) in places.iter().enumerate() {
            let c = Mat2::from_cols(vec2(0.0, 2.0), vec2(-2.0, 0.0));
            points.set(p, AffinePoint { x, v: rotation(x), c, mass: 1.0, ..Default::default() });
        }
        let mut grid = Field::<Node<Ij>, Aos>::new([32, 32]);
        let of = |points: &Field<AffinePoint<Ij>, Soa>| kept(points.iter().map(|point| (point.x, point.v, point.c)));
        let start = of(&points);
        for _ in 0..1000 {
            affine_trip(&mut points, &mut grid, &mpm, usual);
        }
        let end = of(&points);
        assert!((end.0 / start.0 - 1.0).abs() < 2e-5 && (end.1 / start.1 - 1.0).abs() < 4e-5, "{start:?}: {end:?}");
    }
}

/// Nodes with velocities between -1 and 1 that have nothing to do with each other.
fn noise(grid: &mut Field<Node<Ij>, Aos, Ij>) {
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / 2f32.powi(23) - 1.0
    };
    for i in 0..32 {
        for j in 0..32 {
            grid.set([i, j], Node { v: vec2(next(), next()), m: 0.0 });
        }
    }
}

/// Grid to particles to grid: the greatest difference of a velocity where there is mass, and the share of kinetic energy
/// that is left.
fn polynomial_trip(modes: usize) -> (f32, f64) {
    // 16 x 16 particles, 4 a cell.
    let at = |n: usize| 0.375 + (n as f32 + 0.5) / 64.0;
    let places: Vec<Vec2> = (0..16).flat_map(|i| (0..16).map(move |j| vec2(at(i), at(j)))).collect();
    let mpm = still(Scheme::PolyPic { modes }, Spline::Quadratic);
    let mut points = Field::<PolynomialPoint<Ij>, AoSoA<16>>::new([places.len()]);
    for (p, &x) in places.iter().enumerate() {
        points.set(p, PolynomialPoint { x, mass: 1.0, ..Default::default() });
    }
    let mut before = Field::<Node<Ij>, Aos>::new([32, 32]);
    noise(&mut before);
    polynomial::grid_to_particle(&mut points, &before, &mpm);
    let mut after = Field::<Node<Ij>, Aos>::new([32, 32]);
    polynomial::particle_to_grid(&points, &mut after, &mpm);
    let (mut worst, mut old, mut new) = (0f32, 0.0, 0.0);
    for (before, after) in before.iter().zip(after.iter()).filter(|(_, after)| after.m > 0.0) {
        let v = after.v / after.m;
        // Where only the last bit of a weight arrives, its rounding is all there is.
        if after.m > 1e-3 {
            worst = worst.max((v - before.v).abs().max_element());
        }
        old += f64::from(after.m * before.v.length_squared());
        new += f64::from(after.m * v.length_squared());
    }
    (worst, new / old)
}

#[test]
fn polypic_with_all_modes_is_the_identity_on_the_grid() {
    let (worst, energy) = polynomial_trip(9);
    assert!(worst < 2e-5 && (energy - 1.0).abs() < 1e-5, "{worst}, {energy}");
    // Fewer modes keep less: of white noise about what an independent program kept of another draw of it.
    let shares: Vec<f64> = [1, 3, 4, 6].map(|modes| polynomial_trip(modes).1).to_vec();
    for (share, expected) in shares.iter().zip([0.21, 0.50, 0.61, 0.81]) {
        assert!((share - expected).abs() < 0.08, "{shares:?}");
    }
}

#[test]
fn polypic_in_space_with_all_modes_is_the_identity_too() {
    let transfer = Transfer { scheme: Scheme::PolyPic { modes: 27 }, ..Transfer::default() };
    let scene = scene(3, transfer);
    let mut mpm = Transfers::<Ijk>::new(&scene, scene.setup().unwrap());
    (mpm.constants.dt, mpm.constants.impulse) = (0.0, 0.0);
    let mut before = Field::<Node<Ijk>, Aos>::new([32, 32, 32]);
    for i in 0..32i32 {
        for j in 0..32i32 {
            for k in 0..32i32 {
                let v = vec3((i * 7 % 5) as f32, (j * 3 % 7) as f32, ((i + j * k) % 3) as f32) - 2.0;
                before.set([i, j, k], Node { v, m: 0.0 });
            }
        }
    }
    let mut points = Field::<PolynomialPoint<Ijk>, Soa>::new([500]);
    for p in 0..500usize {
        let x = Vec3::from_array([p * 37 % 500, p * 91 % 500, p].map(|n| 0.2 + 0.6 * n as f32 / 500.0));
        points.set(p, PolynomialPoint { x, mass: 1.0, ..Default::default() });
    }
    polynomial::grid_to_particle(&mut points, &before, &mpm);
    let mut after = Field::<Node<Ijk>, Soa>::new([32, 32, 32]);
    polynomial::particle_to_grid(&points, &mut after, &mpm);
    let mut met = 0;
    for (before, after) in before.iter().zip(after.iter()).filter(|(_, after)| after.m > 1e-3) {
        assert!((after.v / after.m - before.v).abs().max_element() < 2e-4, "{before:?} became {after:?}");
        met += 1;
    }
    assert!(met > 5000, "{met}");
}

#[test]
fn one_mode_is_pic_and_those_of_degree_one_are_apic() {
    let places = disk(0.25);
    for modes in [1, 3] {
        let mpm = still(Scheme::PolyPic { modes }, Spline::Quadratic);
        let mut grid = Field::<Node<Ij>, Aos>::new([32, 32]);
        noise(&mut grid);
        let mut rich = Field::<PolynomialPoint<Ij>, Soa>::new([places.len()]);
        let mut affine_points = Field::<AffinePoint<Ij>, Soa>::new([places.len()]);
        for (p, &x) in places.iter().enumerate() {
            rich.set(p, PolynomialPoint { x, mass: 1.0, ..Default::default() });
            affine_points.set(p, AffinePoint { x, mass: 1.0, ..Default::default() });
        }
        polynomial::grid_to_particle(&mut rich, &grid, &mpm);
        affine::grid_to_particle(&mut affine_points, &grid, &still(Scheme::Apic, Spline::Quadratic));
        for (rich, affine) in rich.iter().zip(affine_points.iter()) {
            assert!((rich.modes[0] - affine.v).length() < 1e-6);
            let c = [rich.modes[1] * 32.0, rich.modes[2] * 32.0];
            let wanted = if modes == 3 { [affine.c.x_axis, affine.c.y_axis] } else { [Vec2::ZERO; 2] };
            assert!((c[0] - wanted[0]).length() + (c[1] - wanted[1]).length() < 1e-3, "{c:?}, not {wanted:?}");
        }
    }
}

#[test]
fn splines_sum_to_one_are_centred_and_have_their_second_moment() {
    for (spline, moment) in [(Spline::Linear, None), (Spline::Quadratic, Some(0.25)), (Spline::Cubic, Some(1.0 / 3.0))]
    {
        let mpm = still(Scheme::Pic, spline);
        for n in 0..100 {
            let x = vec2(0.3 + 0.0031 * n as f32, 0.7 - 0.0017 * n as f32);
            let stencil = mpm.stencil(x);
            let (mut sum, mut first, mut second, mut slope, mut linear) =
                (0.0, Vec2::ZERO, Vec2::ZERO, Vec2::ZERO, Vec2::ZERO);
            let mut weights = mpm;
            weights.constants.least_squares = false;
            let mut nodes = 0;
            for offset in mpm.offsets() {
                let (weight, lever) = (stencil.weight(offset), mpm.lever(&stencil, offset) * 32.0);
                sum += weight;
                first += weight * lever;
                second += weight * lever * lever;
                slope += weights.gradient(&stencil, offset);
                linear += weights.gradient(&stencil, offset) * lever / 32.0;
                nodes += 1;
            }
            assert_eq!(nodes, spline.width() * spline.width());
            assert!((sum - 1.0).abs() < 1e-6 && first.length() < 1e-5, "{spline:?}: {sum}, {first}");
            // A constant field has no gradient, and a linear one has its slope.
            assert!(slope.length() < 1e-3 && (linear - 1.0).length() < 1e-4, "{spline:?}: {slope}, {linear}");
            if let Some(moment) = moment {
                assert!((second - moment).length() < 1e-5, "{spline:?}: {second}");
            }
        }
    }
}
