//! Workloads that need sparse nodes, as users write them, each beside plain Rust.

use std::collections::HashSet;

use allotrope::prelude::*;

use super::Numbers;

/// Lists of the particles in each cell of an unbounded plane.
type Cells = layout!(hash(ij).dynamic(k, 64).aos);
/// Each particle's neighbours.
type Near = layout!(dense(i).dynamic(j, 128).aos);

#[kernel]
fn bin(x: &Field<Vec2, _>, cells: &mut Field<u32, Cells, Ijk>, inv_h: f32) {
    cells.clear();
    for p in x {
        cells.append((x[p] * inv_h).floor().as_ivec2(), p as u32);
    }
}

#[kernel]
fn density(x: &Field<Vec2, _>, cells: &Field<u32, Cells, Ijk>, rho: &mut Field<f32, _>, h: f32) {
    for p in x {
        let xp = x[p];
        let c = (xp / h).floor().as_ivec2();
        let mut sum = 0.0;
        for (a, b) in unroll!(-1..2, -1..2) {
            for e in cells.row(c + ivec2(a, b)) {
                let d = (xp - x[cells[e]]).length();
                sum += (1.0 - d / h).max(0.0);
            }
        }
        rho[p] = sum;
    }
}

#[kernel]
fn neighbours(x: &Field<Vec2, _>, cells: &Field<u32, Cells, Ijk>, near: &mut Field<u32, Near, Ij>, h: f32) {
    near.clear();
    for p in x {
        let c = (x[p] / h).floor().as_ivec2();
        for (a, b) in unroll!(-1..2, -1..2) {
            for (i, j, e) in cells.row(c + ivec2(a, b)) {
                let q = cells[(i, j, e)];
                if q != p as u32 && (x[p] - x[q]).length_squared() < h * h {
                    near.append(p, q);
                }
            }
        }
    }
}

#[kernel]
fn count(near: &Field<u32, Near, Ij>, counts: &mut Field<u32, _>) {
    for p in counts {
        counts[p] = near.len(p) as u32;
        for e in near.row(p) {
            counts[p] += 1000 * (near[e] != p as u32) as u32;
        }
    }
}

#[test]
fn particles_in_lists_of_cells() {
    let (n, h) = (2000, 0.1f32);
    let mut numbers = Numbers(5);
    let mut x = Field::<Vec2, Soa>::new([n]);
    for p in 0..n {
        let c = |numbers: &mut Numbers| numbers.below(2000) as f32 / 1000.0 - 1.0;
        x.set(p, vec2(c(&mut numbers), c(&mut numbers)));
    }
    let all = x.to_vec();
    for threads in [1, 3] {
        Schedule { threads, grain: 50, ..Schedule::default() }.run(|| {
            let mut cells = Field::<u32, Cells, Ijk>::unbounded();
            let mut near = Field::<u32, Near>::new([n]);
            let mut rho = Field::<f32, Aos>::new([n]);
            let mut counts = Field::<u32, Aos>::new([n]);
            for _ in 0..2 {
                bin(&x, &mut cells, 1.0 / h);
                density(&x, &cells, &mut rho, h);
                neighbours(&x, &cells, &mut near, h);
                count(&near, &mut counts);
            }
            for p in (0..n).step_by(37) {
                let close = |&q: &usize| (all[p] - all[q]).length_squared() < h * h;
                let expected = (0..n).filter(|&q| q != p).filter(close).count() as u32;
                assert_eq!(counts.get(p), 1001 * expected);
                let sum: f32 = (0..n).map(|q| (1.0 - (all[p] - all[q]).length() / h).max(0.0)).sum();
                assert!((rho.get(p) - sum).abs() < 1e-4 * sum);
            }
        });
    }
}

/// Conway's Life on an unbounded plane.
type Plane = layout!(hash(ij).bitmasked(ij, 8).aos);

#[kernel]
fn life(now: &Field<u8, Plane, Ij>, next: &mut Field<u8, Plane, Ij>) {
    next.clear();
    for ij in now {
        for (a, b) in unroll!(-1..2, -1..2) {
            let c = ij + ivec2(a, b);
            let mut around = 0;
            for (d, e) in unroll!(-1..2, -1..2) {
                around += now[c + ivec2(d, e)];
            }
            if around == 3 || (around == 4 && now[c] == 1) {
                next[c] |= 1;
            }
        }
    }
}

fn plain_life(now: &HashSet<(i32, i32)>) -> HashSet<(i32, i32)> {
    let around = |(i, j): (i32, i32)| (-1..2).flat_map(move |a| (-1..2).map(move |b| (i + a, j + b)));
    let cells: HashSet<(i32, i32)> = now.iter().flat_map(|&c| around(c)).collect();
    let lives = |&c: &(i32, i32)| match around(c).filter(|c| now.contains(c)).count() {
        3 => true,
        4 => now.contains(&c),
        _ => false,
    };
    cells.into_iter().filter(lives).collect()
}

#[test]
fn life_without_bounds() {
    let mut plain: HashSet<(i32, i32)> = [(0, 1), (1, 3), (2, 0), (2, 1), (2, 4), (2, 5), (2, 6)].into();
    let (mut now, mut next) = (Field::<u8, Plane, Ij>::unbounded(), Field::<u8, Plane, Ij>::unbounded());
    for &(i, j) in &plain {
        now.set([i, j], 1);
    }
    for generation in 0..200 {
        let cells: HashSet<(i32, i32)> = now.active_iter().map(|(at, _)| (at.x, at.y)).collect();
        assert_eq!(cells, plain, "generation {generation}");
        life(&now, &mut next);
        std::mem::swap(&mut now, &mut next);
        plain = plain_life(&plain);
    }
}

/// A quadtree: nodes are appended as they are needed.
#[derive(Record, Clone, Copy, Default)]
struct Node {
    moment: Vec2,
    count: u32,
    children: [u32; 4],
}

#[kernel]
fn insert(bodies: &Field<Vec2, _>, tree: &mut Field<Node, layout!(dynamic(i, 4_000_000).aos)>, size: f32) {
    #[serial]
    for b in bodies {
        let (x, mut cell, mut half, mut centre) = (bodies[b], 0, 0.5 * size, Vec2::splat(0.5 * size));
        loop {
            tree.moment[cell] += x;
            tree.count[cell] += 1;
            if half < 1e-2 * size {
                break;
            }
            let quadrant = (x.x > centre.x) as usize + 2 * (x.y > centre.y) as usize;
            let mut child = tree.children[cell][quadrant];
            if child == 0 {
                child = tree.append((), Node::default()) as u32;
                tree.children[cell][quadrant] = child;
            }
            half *= 0.5;
            centre +=
                half * vec2(if quadrant & 1 == 1 { 1.0 } else { -1.0 }, if quadrant & 2 == 2 { 1.0 } else { -1.0 });
            cell = child;
        }
    }
}

#[test]
fn a_tree_of_appended_nodes() {
    let mut bodies = Field::<Vec2, Aos>::new([500]);
    let mut numbers = Numbers(9);
    for b in 0..500 {
        bodies.set(b, vec2(numbers.below(1000) as f32, numbers.below(1000) as f32));
    }
    let mut tree = Field::<Node, layout!(dynamic(i, 4_000_000).aos)>::new([]);
    tree.append((), Node::default());
    insert(&bodies, &mut tree, 1000.0);
    assert_eq!(tree.get(0).count, 500);
    assert_eq!(tree.get(0).moment, bodies.iter().sum::<Vec2>());
    for (at, node) in tree.active_iter() {
        let below: u32 = node.children.iter().filter(|&&c| c > 0).map(|&c| tree.get(c).count).sum();
        assert!(below == node.count || below == 0, "node {at}");
    }
}

/// Triangles of a surface, each appended by whoever finds it.
#[kernel]
fn crossings(phi: &Field<f32, _, Ij>, out: &mut Field<Vec2, layout!(dynamic(i, 100_000, chunk = 1024).aos)>, n: i32) {
    out.clear();
    for (i, j) in ndrange!(0..n - 1, 0..n - 1) {
        for (a, b) in unroll!(0..2, 0..2) {
            if (a == 0 || b == 0) && a != b && phi[(i, j)] * phi[(i + a, j + b)] < 0.0 {
                let t = phi[(i, j)] / (phi[(i, j)] - phi[(i + a, j + b)]);
                out.append((), vec2(i as f32, j as f32) + t * vec2(a as f32, b as f32));
            }
        }
    }
}

/// New particles at a nozzle; those that are far are taken out.
#[kernel]
fn emit(points: &mut Field<Vec2, layout!(dynamic(i, 10_000, chunk = 256).soa)>, per_step: u32, step: u64) {
    for s in 0..per_step {
        points.append((), vec2(random::<f32>(step, (s, 0)), random::<f32>(step, (s, 1))));
    }
    for p in points {
        points[p] += vec2(0.5, 0.0);
        if points[p].x > 4.0 {
            points.remove(p);
        }
    }
}

#[test]
fn appended_points() {
    let n = 64;
    let mut phi = Field::<f32, Aos>::new([n, n]);
    for i in 0..n {
        for j in 0..n {
            phi.set([i, j], ((i as f32 - 31.0).powi(2) + (j as f32 - 31.3).powi(2)).sqrt() - 20.0);
        }
    }
    let run = |threads, deterministic| {
        let mut out = Field::<Vec2, layout!(dynamic(i, 100_000, chunk = 1024).aos)>::new([]);
        Schedule { threads, deterministic, grain: 64, ..Schedule::default() }
            .run(|| crossings(&phi, &mut out, n as i32));
        out.active_iter().map(|(_, x)| x).collect::<Vec<_>>()
    };
    let points = run(1, false);
    assert!(points.len() > 100 && points.iter().all(|x| ((*x - vec2(31.0, 31.3)).length() - 20.0).abs() < 0.01));
    assert_eq!(run(3, true), points, "deterministic order is the loop's");
    let mut sorted = run(3, false);
    sorted.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).expect("numbers"));
    let mut expected = points;
    expected.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).expect("numbers"));
    assert_eq!(sorted, expected);

    let mut fountain = Field::<Vec2, layout!(dynamic(i, 10_000, chunk = 256).soa)>::new([]);
    let mut counts = Vec::new();
    for step in 0..40 {
        emit(&mut fountain, 100, step);
        counts.push(fountain.active_len());
    }
    // Each lives seven or eight steps.
    assert_eq!(counts[4], 500);
    assert!(counts[10..].iter().all(|&n| (600..=800).contains(&n)), "{counts:?}");
}
