//! Particle to grid and back: the two transfers of MLS-MPM.

use allotrope::prelude::*;

/// A material point.
#[derive(Record, Clone, Copy, Default, Debug)]
pub struct Point {
    /// Position.
    pub x: Vec2,
    /// Velocity.
    pub v: Vec2,
    /// Affine velocity matrix.
    pub c: Mat2,
    /// Volume ratio.
    pub j: f32,
}

/// A grid node: momentum, then velocity; and mass.
#[derive(Record, Clone, Copy, Default, Debug)]
pub struct Node {
    /// Velocity.
    pub v: Vec2,
    /// Mass.
    pub m: f32,
}

/// Constants of the method.
#[derive(Clone, Copy)]
pub struct Mpm {
    /// Cell size.
    pub dx: f32,
    /// Its inverse.
    pub inv_dx: f32,
    /// Time step.
    pub dt: f32,
    /// Mass of a particle.
    pub mass: f32,
    /// 4 E V / dx^2 dt.
    pub stiffness: f32,
}

impl Mpm {
    /// The method on a grid of `side` x `side` nodes.
    pub fn new(side: usize) -> Self {
        let dx = 1.0 / side as f32;
        let dt = 2e-4 * 128.0 / side as f32;
        let volume = 0.25 * dx * dx;
        Self { dx, inv_dx: side as f32, dt, mass: volume, stiffness: 4.0 * dt * 400.0 * volume / (dx * dx) }
    }

    /// The stress term of a volume ratio.
    #[inline(always)]
    pub fn stress(&self, j: f32) -> Mat2 {
        Mat2::from_diagonal(Vec2::splat(-self.stiffness * (j - 1.0)))
    }
}

/// Quadratic B-spline weights at distance `fx` from the first of three nodes.
#[inline(always)]
pub fn quadratic_weights(fx: Vec2) -> [Vec2; 3] {
    let (a, b, c) = (1.5 - fx, fx - 1.0, fx - 0.5);
    [0.5 * a * a, 0.75 - b * b, 0.5 * c * c]
}

/// Scatters mass and momentum of every point to its 3 x 3 nodes.
#[kernel]
pub fn particle_to_grid(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>, mpm: &Mpm) {
    for p in points {
        let x = points.x[p] * mpm.inv_dx;
        let base = (x - 0.5).as_ivec2();
        let fx = x - base.as_vec2();
        let w = quadratic_weights(fx);
        let momentum = mpm.mass * points.v[p];
        let affine = mpm.stress(points.j[p]) + mpm.mass * points.c[p];
        for (i, j) in unroll!(0..3, 0..3) {
            let offset = ivec2(i, j);
            let dpos = (offset.as_vec2() - fx) * mpm.dx;
            let weight = w[i as usize].x * w[j as usize].y;
            grid.v[base + offset] += weight * (momentum + affine * dpos);
            grid.m[base + offset] += weight * mpm.mass;
        }
    }
}

/// Gathers velocities and their gradient, and moves the points.
#[kernel]
pub fn grid_to_particle(points: &mut Field<Point, _>, grid: &Field<Node, _, Ij>, mpm: &Mpm) {
    for p in points {
        let x = points.x[p] * mpm.inv_dx;
        let base = (x - 0.5).as_ivec2();
        let fx = x - base.as_vec2();
        let w = quadratic_weights(fx);
        let (mut v, mut c) = (Vec2::ZERO, Mat2::ZERO);
        for (i, j) in unroll!(0..3, 0..3) {
            let offset = ivec2(i, j);
            let dpos = offset.as_vec2() - fx;
            let weighted = w[i as usize].x * w[j as usize].y * grid.v[base + offset];
            v += weighted;
            c += Mat2::from_cols(weighted * dpos.x, weighted * dpos.y);
        }
        let c = c * (4.0 * mpm.inv_dx);
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += mpm.dt * v;
        points.j[p] *= 1.0 + mpm.dt * (c.x_axis.x + c.y_axis.y);
    }
}

/// Points spread over the middle of the domain, in the order of cells.
pub fn sorted_points(count: usize, side: usize) -> Vec<Point> {
    let mut points = drawn_points(count);
    let cell = |p: &Point| (p.x * side as f32).as_ivec2();
    points.sort_by_key(|p| (cell(p).x, cell(p).y));
    points
}

/// Points as they are drawn, in no order.
pub fn drawn_points(count: usize) -> Vec<Point> {
    let mut state = 42u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1u64 << 24) as f32
    };
    (0..count)
        .map(|_| Point {
            x: vec2(0.1 + 0.8 * random(), 0.1 + 0.8 * random()),
            v: vec2(random(), random()),
            c: Mat2::from_cols_array(&[random(), random(), random(), random()]),
            j: 1.0 + 0.01 * random(),
        })
        .collect()
}
