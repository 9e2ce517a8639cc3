//! Finite elements: forces of triangles scattered to their vertices, and a matrix-free product over a grid of squares.

#![allow(clippy::needless_range_loop, reason = "the references index as the formulas do")]

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[derive(Record, Clone, Copy, Default)]
struct Vertex {
    x: Vec2,
    f: Vec2,
}

#[derive(Record, Clone, Copy, Default)]
struct Triangle {
    verts: [u32; 3],
    rest_inverse: Mat2,
    area: f32,
}

/// The first Piola-Kirchhoff stress of the neo-Hookean solid.
fn stress(f: Mat2, mu: f32, lambda: f32) -> Mat2 {
    let f_it = f.inverse().transpose();
    mu * (f - f_it) + lambda * f.determinant().ln() * f_it
}

#[kernel]
fn neo_hookean(tris: &Field<Triangle, _>, verts: &mut Field<Vertex, _>, mu: f32, lambda: f32) {
    for t in tris {
        let [a, b, c] = tris.verts[t];
        let d = Mat2::from_cols(verts.x[b] - verts.x[a], verts.x[c] - verts.x[a]);
        let p = stress(d * tris.rest_inverse[t], mu, lambda);
        let h = -tris.area[t] * (p * tris.rest_inverse[t].transpose());
        verts.f[b] += h.x_axis;
        verts.f[c] += h.y_axis;
        verts.f[a] -= h.x_axis + h.y_axis;
    }
}

/// The energy of a triangle's deformation.
fn energy(tri: &Triangle, x: &[Vec2], mu: f32, lambda: f32) -> f64 {
    let [a, b, c] = tri.verts.map(|v| x[v as usize].as_dvec2());
    let f = DMat2::from_cols(b - a, c - a) * tri.rest_inverse.as_dmat2();
    let (j, square) = (f.determinant(), f.x_axis.length_squared() + f.y_axis.length_squared());
    let (mu, lambda) = (f64::from(mu), f64::from(lambda));
    f64::from(tri.area) * (0.5 * mu * (square - 2.0 - 2.0 * j.ln()) + 0.5 * lambda * j.ln().powi(2))
}

#[test]
fn forces_are_the_slope_of_the_energy() {
    fn run<T: Layout<I>, V: Layout<I>>() {
        let rest: Vec<Vec2> = (0..16).map(|n| vec2((n % 4) as f32, (n / 4) as f32)).collect();
        let x: Vec<Vec2> = (0..16).map(|n| 1.1 * rest[n] + 0.2 * vec2(scattered(n), scattered(n + 50))).collect();
        let mut list = Vec::new();
        for n in (0..12u32).filter(|n| n % 4 < 3) {
            for verts in [[n, n + 1, n + 4], [n + 5, n + 4, n + 1]] {
                let [a, b, c] = verts.map(|v| rest[v as usize]);
                let d = Mat2::from_cols(b - a, c - a);
                list.push(Triangle { verts, rest_inverse: d.inverse(), area: 0.5 * d.determinant() });
            }
        }
        let total = |x: &[Vec2]| list.iter().map(|tri| energy(tri, x, 3.0, 5.0)).sum::<f64>();
        let slope = |n: usize, axis: usize| {
            let moved = |by: f32| {
                let mut x = x.clone();
                x[n][axis] += by;
                total(&x)
            };
            (-(moved(1e-3) - moved(-1e-3)) / 2e-3) as f32
        };
        let expected: Vec<f32> = (0..16).flat_map(|n| [slope(n, 0), slope(n, 1)]).collect();
        on_threads(|| {
            let mut tris = Field::<Triangle, T>::new([list.len()]);
            list.iter().enumerate().for_each(|(n, tri)| tris.set(n, *tri));
            let mut verts = Field::<Vertex, V>::new([16]);
            verts.members_mut().x.copy_from_slice(&x);
            neo_hookean(&tris, &mut verts, 3.0, 5.0);
            let ours: Vec<f32> = verts.iter().flat_map(|v| v.f.to_array()).collect();
            close(&ours, &expected, 1e-3);
        });
    }
    run::<Aos, Aos>();
    run::<Soa, Split>();
    run::<AoSoA<4>, AoSoA<4>>();
}

#[derive(Record, Clone, Copy, Default)]
struct Node {
    p: Vec2,
    ap: Vec2,
    fixed: bool,
}

#[kernel]
fn elasticity(cells: &Field<f32, _, Ij>, nodes: &mut Field<Node, _, Ij>, ke: &[[f32; 8]; 8], penalty: f32) -> f64 {
    let mut energy = 0.0f64;
    for (i, j) in nodes {
        let mut r = Vec2::ZERO;
        for (a, b) in unroll!(0..2, 0..2) {
            let e = cells.or((i - a, j - b), 0.0).powf(penalty);
            for (c, d) in unroll!(0..2, 0..2) {
                let u = nodes.p.or((i - a + c, j - b + d), Vec2::ZERO);
                let (row, col) = ((4 * a + 2 * b) as usize, (4 * c + 2 * d) as usize);
                r += e * vec2(
                    ke[row][col] * u.x + ke[row][col + 1] * u.y,
                    ke[row + 1][col] * u.x + ke[row + 1][col + 1] * u.y,
                );
            }
        }
        if nodes.fixed[(i, j)] {
            r = Vec2::ZERO;
        }
        nodes.ap[(i, j)] = r;
        energy += nodes.p[(i, j)].dot(r) as f64;
    }
    energy
}

#[test]
fn a_product_is_that_of_the_assembled_matrix() {
    fn run<C: Layout<Ij>, N: Layout<Ij>>() {
        let (n, m) = (6, 5);
        let mut ke = [[0.0; 8]; 8];
        for row in 0..8 {
            for col in 0..=row {
                (ke[row][col], ke[col][row]) = (scattered(8 * row + col), scattered(8 * row + col));
            }
        }
        let density: Vec<f32> = (0..n * m).map(|c| 0.6 + 0.4 * scattered(c)).collect();
        let p: Vec<Vec2> = (0..(n + 1) * (m + 1)).map(|c| vec2(scattered(c), scattered(c + 77))).collect();
        let fixed = |node: usize| node.is_multiple_of(7);
        let mut expected = vec![Vec2::ZERO; p.len()];
        for cell in 0..n * m {
            let (i, j) = (cell / m, cell % m);
            let node = |corner: usize| (i + corner / 2) * (m + 1) + j + corner % 2;
            for row in 0..8 {
                for col in 0..8 {
                    expected[node(row / 2)][row % 2] +=
                        density[cell].powf(3.0) * ke[row][col] * p[node(col / 2)][col % 2];
                }
            }
        }
        expected.iter_mut().enumerate().filter(|(node, _)| fixed(*node)).for_each(|(_, r)| *r = Vec2::ZERO);
        let work: f64 = p.iter().zip(&expected).map(|(p, r)| f64::from(p.dot(*r))).sum();
        on_threads(|| {
            let mut cells = Field::<f32, C>::new([n, m]);
            cells.copy_from_slice(&density);
            let mut nodes = Field::<Node, N>::new([n + 1, m + 1]);
            nodes.members_mut().p.copy_from_slice(&p);
            nodes.members_mut().fixed.copy_from_slice(&(0..p.len()).map(fixed).collect::<Vec<_>>());
            let energy = elasticity(&cells, &mut nodes, &ke, 3.0);
            let flat = |list: &[Vec2]| -> Vec<f32> { list.iter().flat_map(|r| r.to_array()).collect() };
            close(&flat(&nodes.members().ap.to_vec()), &flat(&expected), 1e-5);
            assert!((energy - work).abs() < 1e-4 * work.abs().max(1.0), "{energy} {work}");
        });
    }
    run::<Aos, Aos>();
    run::<Soa, Soa>();
    run::<Blocked<4>, Blocked<2>>();
}
