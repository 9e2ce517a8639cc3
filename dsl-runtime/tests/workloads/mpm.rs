//! The particle and grid kernels of the material point method.

use allotrope::prelude::*;

use crate::instruction_sets;

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node {
    v: Vec2,
    m: f32,
}

/// A material point.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Point {
    x: Vec2,
    v: Vec2,
    c: Mat2,
    j: f32,
}

/// Constants of the method.
struct Mpm {
    inv_dx: f32,
    dx: f32,
    mass: f32,
}

impl Mpm {
    fn stress(&self, j: f32) -> Mat2 {
        Mat2::from_diagonal(Vec2::splat(0.1 * (j - 1.0)))
    }
}

fn quadratic_weights(fx: Vec2) -> [Vec2; 3] {
    [0.5 * (1.5 - fx) * (1.5 - fx), 0.75 - (fx - 1.0) * (fx - 1.0), 0.5 * (fx - 0.5) * (fx - 0.5)]
}

/// Scatters mass and momentum of every point to its 3 x 3 nodes.
#[kernel]
fn particle_to_grid(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>, mpm: &Mpm) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - 0.5).as_ivec2();
        let fx = xp - base.as_vec2();
        let w = quadratic_weights(fx);
        let affine = mpm.stress(points.j[p]) + mpm.mass * points.c[p];
        for (i, j) in unroll!(0..3, 0..3) {
            let offset = ivec2(i, j);
            let dpos = (offset.as_vec2() - fx) * mpm.dx;
            let weight = w[i as usize].x * w[j as usize].y;
            grid.v[base + offset] += weight * (mpm.mass * points.v[p] + affine * dpos);
            grid.m[base + offset] += weight * mpm.mass;
        }
    }
}

/// Gathers velocities back.
#[kernel]
fn grid_to_particle(points: &mut Field<Point, _>, grid: &Field<Node, _, Ij>, mpm: &Mpm, dt: f32) {
    for p in points {
        let xp = points.x[p] * mpm.inv_dx;
        let base = (xp - 0.5).as_ivec2();
        let fx = xp - base.as_vec2();
        let w = quadratic_weights(fx);
        let (mut v, mut c) = (Vec2::ZERO, Mat2::ZERO);
        for (i, j) in unroll!(0..3, 0..3) {
            if grid.m[base + ivec2(i, j)] <= 0.0 {
                continue;
            }
            let dpos = (vec2(i as f32, j as f32) - fx) * mpm.dx;
            let weight = w[i as usize].x * w[j as usize].y;
            let g = grid.v[base + ivec2(i, j)];
            v += weight * g;
            c += 4.0 * weight * mpm.inv_dx * mpm.inv_dx * Mat2::from_cols(g * dpos.x, g * dpos.y);
        }
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += dt * v;
        points.j[p] *= 1.0 + dt * (c.x_axis.x + c.y_axis.y);
    }
}

fn points<L: Layout<I>>(n: usize) -> Field<Point, L> {
    let mut points = Field::<Point, L>::new([n]);
    for p in 0..n {
        let (a, b) = ((p * 7919 % 1000) as f32 / 1000.0, (p * 104_729 % 997) as f32 / 997.0);
        let x = vec2(0.1 + 0.8 * a, 0.1 + 0.8 * b);
        points.set(p, Point { x, v: vec2(b, -a), c: Mat2::IDENTITY * 0.1, j: 1.0 + 0.01 * a });
    }
    points
}

const N: usize = 32;
const MPM: Mpm = Mpm { inv_dx: N as f32, dx: 1.0 / N as f32, mass: 0.25 };

#[test]
fn mass_and_momentum_arrive_under_every_schedule() {
    fn run<P: Layout<I>, G: Layout<Ij>>(scatter: Scatter) {
        let count = 20_000;
        let points = points::<P>(count);
        let mut grid = Field::<Node, G>::new([N, N]);
        let schedule = Schedule { threads: 3, scatter, ..Schedule::default() };
        schedule.run(|| particle_to_grid(&points, &mut grid, &MPM));
        let mass: f64 = grid.iter().map(|node| f64::from(node.m)).sum();
        assert!((mass - 0.25 * count as f64).abs() < 0.5, "{mass}");
        let momentum = grid.iter().fold(DVec2::ZERO, |sum, node| sum + node.v.as_dvec2());
        let expected = points.iter().fold(DVec2::ZERO, |sum, p| sum + 0.25 * p.v.as_dvec2());
        assert!((momentum - expected).length() < 0.5, "{momentum} {expected}");
    }
    for scatter in [Scatter::Serial, Scatter::Atomic, Scatter::Private, Scatter::Colored, Scatter::Auto] {
        run::<Aos, Soa>(scatter);
        run::<AoSoA<16>, Blocked<4>>(scatter);
    }
}

#[test]
fn layouts_and_instruction_sets_agree() {
    fn run<P: Layout<I>, G: Layout<Ij>>() -> Vec<Point> {
        let mut points = points::<P>(500);
        let mut grid = Field::<Node, G>::new([N, N]);
        particle_to_grid(&points, &mut grid, &MPM);
        grid_to_particle(&mut points, &grid, &MPM, 1e-3);
        points.iter().collect()
    }
    let runs = [run::<Aos, Soa>, run::<AoSoA<16>, Blocked<4>>, run::<Aos, Sparse<4>>];
    let with = |scatter, threads, cpu| {
        let schedule = Schedule { threads, scatter, deterministic: true, cpu: Some(cpu), grain: 64 };
        runs.map(|run| schedule.run(run))
    };
    let (serial, private) = (with(Scatter::Serial, 1, Cpu::Baseline), with(Scatter::Private, 1, Cpu::Baseline));
    assert!(serial.iter().all(|points| *points == serial[0]));
    for cpu in instruction_sets() {
        for threads in [1, 3] {
            assert!(with(Scatter::Serial, threads, cpu) == serial, "serial, {cpu}, {threads} threads");
            assert!(with(Scatter::Private, threads, cpu) == private, "private, {cpu}, {threads} threads");
        }
    }
}

#[test]
fn points_outside_panic_with_kernel_field_index_and_shape() {
    let mut points = points::<Aos>(10);
    points.set(7, Point { x: vec2(2.0, 0.5), ..points.get(7) });
    let mut grid = Field::<Node, Soa>::new([N, N]);
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| particle_to_grid(&points, &mut grid, &MPM)));
    let panic = panic.unwrap_err();
    let text = panic.downcast_ref::<String>().expect("a message");
    for part in ["particle_to_grid", "`grid`", "[63, 15]", "[32, 32]"] {
        assert!(text.contains(part), "{text}");
    }
    points.set(7, Point { x: vec2(0.5, 0.5), ..points.get(7) });
    grid.fill(Node::default());
    particle_to_grid(&points, &mut grid, &MPM);
    let mass: f32 = grid.iter().map(|node| node.m).sum();
    assert!((mass - 2.5).abs() < 1e-4, "{mass}");
}
