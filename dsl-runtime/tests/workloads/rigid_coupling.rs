//! Rigid segments on a grid: the nearest segment of each node by a minimum of packed integers, and impulses on bodies.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[derive(Record, Clone, Copy, Default)]
struct Sample {
    x: Vec2,
    segment: u32,
}

#[derive(Record, Clone, Copy, Default)]
struct Segment {
    a: Vec2,
    b: Vec2,
}

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    nearest: u64,
}

#[derive(Record, Clone, Copy, Default)]
struct Body {
    x: Vec2,
    impulse: Vec2,
    torque: f32,
}

/// Distance, segment and side of a node, packed so that the smallest is the nearest.
fn packed(x: Vec2, k: u32, a: Vec2, b: Vec2) -> Option<u64> {
    let t = (x - a).dot(b - a) / (b - a).length_squared();
    let side = ((b - a).perp_dot(x - a) > 0.0) as u64;
    let d = (x - a.lerp(b, t)).length();
    (0.0..=1.0).contains(&t).then(|| ((d.to_bits() as u64) << 32) | ((k as u64) << 1) | side)
}

#[kernel]
fn colour_nodes(samples: &Field<Sample, _>, segments: &Field<Segment, _>, grid: &mut Field<Node, _, Ij>, inv_dx: f32) {
    for ij in grid {
        grid.nearest[ij] = u64::MAX;
    }
    for s in samples {
        let k = samples.segment[s];
        let (a, b) = (segments.a[k], segments.b[k]);
        let base = (samples.x[s] * inv_dx - 0.5).floor().as_ivec2();
        for (i, j) in unroll!(0..3, 0..3) {
            let node = base + ivec2(i, j);
            if let Some(value) = packed(node.as_vec2() / inv_dx, k, a, b) {
                grid.nearest[node].min_assign(value);
            }
        }
    }
}

#[derive(Record, Clone, Copy, Default)]
struct Point {
    x: Vec2,
    v: Vec2,
    body: u32,
}

/// The sum of velocities of those nodes around a place whose nearest segment has this parity.
#[func]
fn gathered(v: Read<Vec2, _, Ij>, nearest: Read<u64, _, Ij>, x: Vec2, parity: u64) -> (Vec2, u32) {
    let base = (x - 0.5).floor().as_ivec2();
    let (mut sum, mut count) = (Vec2::ZERO, 0);
    for i in 0..3 {
        for j in 0..3 {
            let at = base + ivec2(i, j);
            if nearest[at] == u64::MAX || nearest[at] >> 1 & 1 == parity {
                sum += v[at];
                count += 1;
            }
        }
    }
    (sum, count)
}

#[kernel]
fn gather(points: &mut Field<Point, _>, grid: &Field<Node, _, Ij>, bodies: &mut Field<Body, _>, inv_dx: f32) {
    #[scatter(Private)]
    for p in points {
        let point = points[p];
        let (sum, count) = gathered(grid.v, grid.nearest, point.x * inv_dx, point.body as u64 % 2);
        if count > 0 {
            let v = sum / count as f32;
            let b = point.body;
            let impulse = point.v - v;
            points.v[p] = v;
            bodies.impulse[b] += impulse;
            bodies.torque[b] += (point.x - bodies.x[b]).perp_dot(impulse);
        }
    }
}

#[test]
fn nodes_and_impulses_are_as_in_plain_rust() {
    fn run<P: Layout<I>, G: Layout<Ij>>() {
        let (n, inv_dx) = (12usize, 10.0f32);
        let place = |k: usize| 0.6 + 0.4 * vec2(scattered(k), scattered(k + 300));
        let list: Vec<Segment> = (0..4).map(|k| Segment { a: place(k), b: place(k + 40) }).collect();
        let along: Vec<Sample> = (0..80)
            .map(|s| Sample { x: list[s % 4].a.lerp(list[s % 4].b, s as f32 / 80.0), segment: (s % 4) as u32 })
            .collect();
        let mut nearest = vec![u64::MAX; n * n];
        for sample in &along {
            let base = (sample.x * inv_dx - 0.5).floor().as_ivec2();
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let (node, segment) = (base + ivec2(i, j), &list[sample.segment as usize]);
                if let Some(value) = packed(node.as_vec2() / inv_dx, sample.segment, segment.a, segment.b) {
                    let at = node.x as usize * n + node.y as usize;
                    nearest[at] = nearest[at].min(value);
                }
            }
        }
        let velocity: Vec<Vec2> = (0..n * n).map(|c| vec2(scattered(c + 700), scattered(c + 900))).collect();
        let moving: Vec<Point> =
            (0..50).map(|p| Point { x: place(p + 80), v: vec2(scattered(p), 0.5), body: (p % 3) as u32 }).collect();
        let (mut impulses, mut torques, mut speeds) = ([Vec2::ZERO; 3], [0.0f32; 3], Vec::new());
        for point in &moving {
            let base = (point.x * inv_dx - 0.5).floor().as_ivec2();
            let near = (0..9).map(|c| (base.x as usize + c / 3) * n + base.y as usize + c % 3);
            let chosen: Vec<Vec2> = near
                .filter(|&at| nearest[at] == u64::MAX || nearest[at] >> 1 & 1 == point.body as u64 % 2)
                .map(|at| velocity[at])
                .collect();
            let v = if chosen.is_empty() { point.v } else { chosen.iter().sum::<Vec2>() / chosen.len() as f32 };
            impulses[point.body as usize] += point.v - v;
            torques[point.body as usize] += (point.x - 0.5).perp_dot(point.v - v);
            speeds.extend(v.to_array());
        }
        on_threads(|| {
            let mut samples = Field::<Sample, P>::new([along.len()]);
            along.iter().enumerate().for_each(|(s, sample)| samples.set(s, *sample));
            let mut segments = Field::<Segment, Aos>::new([4]);
            list.iter().enumerate().for_each(|(k, segment)| segments.set(k, *segment));
            let mut grid = Field::<Node, G>::new([n, n]);
            colour_nodes(&samples, &segments, &mut grid, inv_dx);
            assert_eq!(grid.members().nearest.to_vec(), nearest);
            assert!(nearest.iter().any(|value| *value != u64::MAX), "some nodes are near");

            grid.members_mut().v.copy_from_slice(&velocity);
            let mut points = Field::<Point, P>::new([moving.len()]);
            moving.iter().enumerate().for_each(|(p, point)| points.set(p, *point));
            let mut bodies = Field::<Body, Aos>::new([3]);
            bodies.fill(Body { x: Vec2::splat(0.5), ..Body::default() });
            gather(&mut points, &grid, &mut bodies, inv_dx);
            close(&points.iter().flat_map(|p| p.v.to_array()).collect::<Vec<_>>(), &speeds, 1e-5);
            let flat: Vec<f32> = bodies.iter().flat_map(|b| [b.impulse.x, b.impulse.y, b.torque]).collect();
            let expected: Vec<f32> = (0..3).flat_map(|b| [impulses[b].x, impulses[b].y, torques[b]]).collect();
            close(&flat, &expected, 1e-5);
        });
    }
    run::<Aos, Aos>();
    run::<Soa, Blocked<4>>();
    run::<AoSoA<8>, Morton<4>>();
}
