//! Transfers between the levels of a multigrid: affine indices, boundary reads, components of an index by bits.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[kernel]
fn restrict_cells(fine: &Field<f32, _, Ij>, coarse: &mut Field<f32, _, Ij>) {
    for (i, j) in coarse {
        let mut s = 0.0;
        for (a, b) in unroll!(0..2, 0..2) {
            s += fine[(2 * i + a, 2 * j + b)];
        }
        coarse[(i, j)] = 0.25 * s;
    }
}

#[kernel]
fn prolong_cells(coarse: &Field<f32, _, Ij>, fine: &mut Field<f32, _, Ij>) {
    for (i, j) in fine {
        let (ci, cj) = (i >> 1, j >> 1);
        let (si, sj) = (2 * (i & 1) - 1, 2 * (j & 1) - 1);
        let near = coarse[(ci, cj)];
        let sides = coarse.clamped((ci + si, cj)) + coarse.clamped((ci, cj + sj));
        fine[(i, j)] += (9.0 * near + 3.0 * sides + coarse.clamped((ci + si, cj + sj))) / 16.0;
    }
}

/// Faces normal to i, extents (n + 1, m) fine and (n / 2 + 1, m / 2) coarse: full weighting along i, mean along j.
#[kernel]
fn restrict_faces(fine: &Field<f32, _, Ij>, coarse: &mut Field<f32, _, Ij>) {
    for (i, j) in coarse {
        let mut s = 0.0;
        for b in unroll!(0..2) {
            s += 2.0 * fine[(2 * i, 2 * j + b)]
                + fine.clamped((2 * i - 1, 2 * j + b))
                + fine.clamped((2 * i + 1, 2 * j + b));
        }
        coarse[(i, j)] = s / 8.0;
    }
}

fn field<L: Layout<Ij>>(n: usize, m: usize) -> (Field<f32, L, Ij>, Vec<f32>) {
    let values: Vec<f32> = (0..n * m).map(scattered).collect();
    let mut field = Field::<f32, L>::new([n, m]);
    field.copy_from_slice(&values);
    (field, values)
}

#[test]
fn transfers_are_as_in_plain_rust() {
    fn run<L: Layout<Ij>>() {
        let (n, m) = (12, 10);
        let (cells, values) = field::<L>(n, m);
        let (faces, face_values) = field::<L>(n + 1, m);
        let clamped = |values: &[f32], n: usize, m: usize, i: i32, j: i32| {
            values[i.clamp(0, n as i32 - 1) as usize * m + j.clamp(0, m as i32 - 1) as usize]
        };
        let half: Vec<f32> = (0..n / 2 * m / 2)
            .map(|c| {
                let (i, j) = (c / (m / 2), c % (m / 2));
                let at = |a: usize, b: usize| values[(2 * i + a) * m + 2 * j + b];
                0.25 * (at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1))
            })
            .collect();
        let risen: Vec<f32> = (0..n * m)
            .map(|c| {
                let (i, j) = ((c / m) as i32, (c % m) as i32);
                let (si, sj) = (if i % 2 == 1 { 1 } else { -1 }, if j % 2 == 1 { 1 } else { -1 });
                let at = |a: i32, b: i32| clamped(&half, n / 2, m / 2, i / 2 + a, j / 2 + b);
                values[c] + (9.0 * at(0, 0) + 3.0 * (at(si, 0) + at(0, sj)) + at(si, sj)) / 16.0
            })
            .collect();
        let half_faces: Vec<f32> = (0..(n / 2 + 1) * (m / 2))
            .map(|c| {
                let (i, j) = (2 * (c / (m / 2)) as i32, 2 * (c % (m / 2)) as i32);
                let at = |a: i32, b: i32| clamped(&face_values, n + 1, m, i + a, j + b);
                (0..2).map(|b| 2.0 * at(0, b) + at(-1, b) + at(1, b)).sum::<f32>() / 8.0
            })
            .collect();
        on_threads(|| {
            let mut coarse = Field::<f32, L>::new([n / 2, m / 2]);
            restrict_cells(&cells, &mut coarse);
            close(&coarse.to_vec(), &half, 1e-6);
            let mut fine = cells.clone();
            prolong_cells(&coarse, &mut fine);
            close(&fine.to_vec(), &risen, 1e-6);
            let mut coarse_faces = Field::<f32, L>::new([n / 2 + 1, m / 2]);
            restrict_faces(&faces, &mut coarse_faces);
            close(&coarse_faces.to_vec(), &half_faces, 1e-6);
        });
    }
    run::<Aos>();
    run::<layout!(dense(ji).soa)>();
    run::<Blocked<4>>();
}
