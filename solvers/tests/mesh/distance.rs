//! Signed distances from closed meshes.

use std::collections::HashSet;

use allotrope_solvers::mesh::{ClosedMesh, SignedDistance, read, read_obj};

use super::{BUNNY, cube};

/// A ball of the radius one about (1, 2, 3): an octahedron whose triangles are cut in four again and again.
fn ball() -> ClosedMesh {
    let mut triangles = Vec::new();
    for n in 0..8 {
        let sign = [0, 1, 2].map(|axis| if n >> axis & 1 == 0 { 1.0 } else { -1.0 });
        let [x, y, z] = [[sign[0], 0.0, 0.0], [0.0, sign[1], 0.0], [0.0, 0.0, sign[2]]];
        triangles.push(if sign.iter().product::<f64>() > 0.0 { [x, y, z] } else { [x, z, y] });
    }
    for _ in 0..5 {
        let middle = |a: [f64; 3], b: [f64; 3]| {
            let sum = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
            let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
            sum.map(|x| x / length)
        };
        let cut = |[a, b, c]: [[f64; 3]; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(cut).collect();
    }
    let mut text = "solid ball\n".to_string();
    for triangle in triangles {
        for [x, y, z] in triangle {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\n";
    }
    read("ball.stl", (text + "endsolid").as_bytes()).unwrap().closed().unwrap().placed(1.0, [1.0, 2.0, 3.0])
}

/// Places in a box, the same every time, that lie on no lattice.
fn places(low: [f64; 3], high: [f64; 3], count: u32) -> impl Iterator<Item = [f64; 3]> {
    // Fractions of multiples of roots, as good as random here.
    let roots = [2f64.sqrt(), 3f64.sqrt(), 5f64.sqrt()];
    (1..=count)
        .map(move |n| [0, 1, 2].map(|axis| low[axis] + (high[axis] - low[axis]) * (f64::from(n) * roots[axis]).fract()))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[test]
fn distances_from_a_ball_are_those_from_its_middle_less_the_radius() {
    let (center, spacing) = ([1.0, 2.0, 3.0], 0.05);
    let distances = SignedDistance::new(&ball(), spacing);
    let (mut worst, mut near) = (0f64, 0f64);
    for x in places(center.map(|c| c - 1.09), center.map(|c| c + 1.09), 20_000) {
        let arm: [f64; 3] = std::array::from_fn(|axis| x[axis] - center[axis]);
        let length = dot(arm, arm).sqrt();
        let (distance, normal) = distances.at(x).unwrap();
        assert!((dot(normal, normal) - 1.0).abs() < 1e-12);
        // The mesh lies within its facets' sagitta, 0.0012, of the ball; interpolation adds a curvature's.
        let error = (distance - (length - 1.0)).abs();
        worst = worst.max(if length > 2.0 * spacing { error } else { 0.0 });
        if (length - 1.0).abs() < 0.1 {
            near = near.max(error);
            assert!(dot(normal, arm) / length > 0.997, "{x:?}: {normal:?}");
            assert!((distance < 0.0) == (length < 1.0) || error < 0.003, "{x:?}: {distance}");
        }
    }
    assert!(near < 0.003 && near > 0.0, "{near}");
    assert!(worst < 0.01, "{worst}");
    // In its very middle no way out is the shortest.
    let (middle, normal) = distances.at(center).unwrap();
    assert!((middle + 1.0).abs() < 0.05 && (dot(normal, normal) - 1.0).abs() < 1e-12, "{middle} {normal:?}");
    // Two cells around the mesh, and no more.
    assert!(distances.at([1.0, 2.0, 3.0 + 1.099]).is_some() && distances.at([1.0, 2.0, 3.0 + 1.16]).is_none());
    assert!(distances.at([f64::NAN, 2.0, 3.0]).is_none());
}

#[test]
fn distances_from_a_cube_are_exact_at_nodes() {
    let mesh = read_obj(cube(&[0, 1, 2, 3, 4, 5]).as_bytes()).unwrap().closed().unwrap();
    // From 9.75 to 11.25 in steps of an eighth; faces lie on nodes.
    let distances = SignedDistance::new(&mesh, 0.125);
    let nodes = (0..13 * 13 * 13).map(|n: u32| [n / 169, n / 13 % 13, n % 13].map(|n| 9.75 + 0.125 * f64::from(n)));
    for x in nodes {
        let beyond = x.map(|x| (x - 10.5).abs() - 0.5);
        let outside = beyond.map(|b| b.max(0.0));
        let exact = dot(outside, outside).sqrt() + beyond.into_iter().fold(f64::NEG_INFINITY, f64::max).min(0.0);
        let (distance, _) = distances.at(x).unwrap();
        assert!((distance - exact).abs() < 1e-6, "{x:?}: {distance} of {exact}");
    }
    // Over the middle of a face all is linear.
    let (distance, normal) = distances.at([10.4, 11.07, 10.6]).unwrap();
    assert!((distance - 0.07).abs() < 1e-6, "{distance}");
    assert!(normal[0].abs() < 1e-5 && (normal[1] - 1.0).abs() < 1e-6 && normal[2].abs() < 1e-5, "{normal:?}");
}

#[test]
fn the_side_is_that_by_which_the_bunny_is_filled() {
    let bunny = read_obj(BUNNY).unwrap().closed().unwrap();
    let spacing = 0.1;
    let distances = SignedDistance::new(&bunny, spacing);
    // A lattice of another spacing, of which the points inside are told.
    let other = 0.17;
    let inside = bunny.fill(other);
    let key = |x: &[f64; 3]| x.map(|x| (x / other * 4.0).round() as i64);
    let known: HashSet<_> = inside.iter().map(key).collect();
    let (low, high) = bunny.bounds();
    let first = inside[0];
    let (mut sides, mut unsure) = ([0, 0], 0);
    let along = |axis: usize| {
        let from = ((low[axis] - first[axis]) / other).floor() as i32;
        let to = ((high[axis] - first[axis]) / other).ceil() as i32;
        (from..=to).map(move |n| first[axis] + f64::from(n) * other)
    };
    for x in along(0).flat_map(|x| along(1).flat_map(move |y| along(2).map(move |z| [x, y, z]))) {
        let (distance, _) = distances.at(x).unwrap();
        // Nearer than a cell's half, thin parts and edges may be lost between nodes.
        if distance.abs() < 0.5 * spacing {
            unsure += 1;
            continue;
        }
        let is_inside = known.contains(&key(&x));
        assert_eq!(distance < 0.0, is_inside, "{x:?}: {distance}");
        sides[usize::from(is_inside)] += 1;
    }
    assert!(sides[0] > 10_000 && sides[1] > 10_000 && unsure < 8_000, "{sides:?} {unsure}");
}

#[test]
fn a_lattice_that_would_be_too_large_is_coarser() {
    let mesh = read_obj(cube(&[0, 1, 2, 3, 4, 5]).as_bytes()).unwrap().closed().unwrap();
    let distances = SignedDistance::new(&mesh.placed(1.0, [-10.5; 3]), 1e-9);
    let (distance, _) = distances.at([0.5, 0.25, 0.0]).unwrap();
    assert!(distance.abs() < 1e-6, "{distance}");
}
