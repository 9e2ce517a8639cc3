//! A fluid by the moving least squares material point method, after the famous program of 88 lines: two blocks of water fall
//! into a tank. `cargo run --release --example mpm88 [FILE.png]`

use std::path::Path;

use allotrope::prelude::*;
use image::{ImageResult, Rgb, RgbImage};

const POINTS: usize = 8192;
const NODES: usize = 128; // an axis, of a tank one metre wide
const DX: f32 = 1.0 / NODES as f32;
const DT: f32 = 2e-4;
const MASS: f32 = 0.25 * DX * DX; // of a point: four to a cell, of density 1
const STIFFNESS: f32 = 400.0;
const GRAVITY: Vec2 = vec2(0.0, -9.8);
const WALL: i32 = 3; // nodes from the border that are solid

/// A material point.
#[derive(Record, Clone, Copy, Default)]
pub struct Point {
    /// Position.
    pub x: Vec2,
    /// Velocity.
    pub v: Vec2,
    /// Gradient of velocity.
    pub c: Mat2,
    /// Volume by that at rest.
    pub j: f32,
}

/// A grid node.
#[derive(Record, Clone, Copy, Default)]
pub struct Node {
    /// Momentum, then velocity.
    pub v: Vec2,
    /// Mass.
    pub m: f32,
}

/// The first of a position's 3 x 3 nodes, the distance from it in cells, and the quadratic weights along both axes.
fn stencil(x: Vec2) -> (IVec2, Vec2, [Vec2; 3]) {
    let base = (x / DX - 0.5).as_ivec2();
    let fx = x / DX - base.as_vec2();
    (base, fx, [0.5 * (1.5 - fx) * (1.5 - fx), 0.75 - (fx - 1.0) * (fx - 1.0), 0.5 * (fx - 0.5) * (fx - 0.5)])
}

/// A time step.
#[kernel]
pub fn step(points: &mut Field<Point, _>, grid: &mut Field<Node, _, Ij>) {
    for ij in grid {
        grid[ij] = Node { v: Vec2::ZERO, m: 0.0 };
    }
    for p in points {
        let (base, fx, w) = stencil(points.x[p]);
        let pressure = -4.0 * DT * STIFFNESS * MASS * (points.j[p] - 1.0) / (DX * DX);
        let affine = Mat2::from_diagonal(Vec2::splat(pressure)) + MASS * points.c[p];
        for (i, j) in unroll!(0..3, 0..3) {
            let weight = w[i as usize].x * w[j as usize].y;
            let momentum = MASS * points.v[p] + affine * (DX * (vec2(i as f32, j as f32) - fx));
            grid.v[base + ivec2(i, j)] += weight * momentum; // many points meet at a node: no update is lost
            grid.m[base + ivec2(i, j)] += weight * MASS;
        }
    }
    for (i, j) in grid {
        if grid.m[(i, j)] > 0.0 {
            let v = grid.v[(i, j)] / grid.m[(i, j)] + DT * GRAVITY;
            let before = ivec2(i, j).cmplt(IVec2::splat(WALL)) & v.cmplt(Vec2::ZERO);
            let behind = ivec2(i, j).cmpgt(IVec2::splat(NODES as i32 - WALL)) & v.cmpgt(Vec2::ZERO);
            grid.v[(i, j)] = Vec2::select(before | behind, Vec2::ZERO, v); // nothing flows out
        }
    }
    for p in points {
        let (base, fx, w) = stencil(points.x[p]);
        let (mut v, mut c) = (Vec2::ZERO, Mat2::ZERO);
        for (i, j) in unroll!(0..3, 0..3) {
            let node = w[i as usize].x * w[j as usize].y * grid.v[base + ivec2(i, j)];
            v += node;
            c += 4.0 / DX * Mat2::from_cols(node * (i as f32 - fx.x), node * (j as f32 - fx.y));
        }
        points.v[p] = v;
        points.c[p] = c;
        points.x[p] += DT * v;
        points.j[p] *= 1.0 + DT * (c.x_axis.x + c.y_axis.y);
    }
}

/// Two blocks of points, evenly spread by the plastic number, that fall.
pub fn blocks<L: Layout<I>>() -> Field<Point, L> {
    let mut points = Field::<Point, L>::new([POINTS]);
    for p in 0..POINTS {
        let unit = (p as f64 * dvec2(0.754_877_666_246_693, 0.569_840_290_998_053)).fract().as_vec2();
        let corner = if p % 2 == 0 { vec2(0.1, 0.1) } else { vec2(0.5, 0.5) };
        points.set(p, Point { x: corner + 0.25 * unit, v: vec2(0.0, -1.0), c: Mat2::ZERO, j: 1.0 });
    }
    points
}

/// Writes the points as a picture.
pub fn draw<L: Layout<I>>(points: &Field<Point, L>, file: &Path) -> ImageResult<()> {
    let mut picture = RgbImage::from_pixel(512, 512, Rgb([17, 47, 65]));
    for (p, point) in points.iter().enumerate() {
        let at = (512.0 * vec2(point.x.x, 1.0 - point.x.y)).clamp(Vec2::ZERO, Vec2::splat(511.0)).as_uvec2();
        picture.put_pixel(at.x, at.y, Rgb(if p % 2 == 0 { [6, 133, 135] } else { [242, 177, 52] }));
    }
    picture.save(file)
}

fn main() -> ImageResult<()> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "mpm88.png".into());
    let mut points = blocks::<Aos>();
    let mut grid = Field::<Node, Blocked<4>>::new([NODES, NODES]);
    for frame in 1..=10 {
        for _ in 0..200 {
            step(&mut points, &mut grid);
        }
        let height = points.members().x.to_vec().iter().map(|x| x.y).sum::<f32>() / POINTS as f32;
        println!("{:.2} s: mean height {height:.3} m", 200.0 * DT * frame as f32);
    }
    draw(&points, Path::new(&file))
}
