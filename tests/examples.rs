//! What the examples compute. They are included as they stand, so that what is checked is what users read.

#[allow(dead_code, unreachable_pub, reason = "its `main` is for users")]
#[path = "../examples/julia.rs"]
mod julia;

#[allow(dead_code, unreachable_pub, reason = "its `main` and the picture are for users")]
#[path = "../examples/mpm88.rs"]
mod mpm88;

use allotrope::prelude::*;

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
