//! Jacobi's 5-point step and the 7-point Laplacian.

use super::versions;

versions! {
    /// One step over rows: four row slices, a vector loop along each.
    pub fn jacobi_rows(n: usize, a: f32, u: &[f32], v: &mut [f32]) {
        for (i, out) in v.chunks_exact_mut(n).enumerate().skip(1).take(n - 2) {
            let (up, row, down) = (&u[(i - 1) * n..][..n], &u[i * n..][..n], &u[(i + 1) * n..][..n]);
            for j in 1..n - 1 {
                out[j] = a * (up[j] + down[j] + row[j - 1] + row[j + 1]);
            }
        }
    }
}

versions! {
    /// One step over records of four values, of which the first takes part.
    pub fn jacobi_records(n: usize, a: f32, u: &[[f32; 4]], v: &mut [[f32; 4]]) {
        for (i, out) in v.chunks_exact_mut(n).enumerate().skip(1).take(n - 2) {
            let (up, row, down) = (&u[(i - 1) * n..][..n], &u[i * n..][..n], &u[(i + 1) * n..][..n]);
            for j in 1..n - 1 {
                out[j][0] = a * (up[j][0] + down[j][0] + row[j - 1][0] + row[j + 1][0]);
            }
        }
    }
}

versions! {
    /// One step over blocks of `B` x `B` cells: rows from the block and its four neighbours, whole blocks of results kept in registers
    /// until they are stored, the domain's border block by block apart.
    pub fn jacobi_blocks<const B: usize>(n: usize, a: f32, u: &[f32], v: &mut [f32]) {
        let (blocks, cells) = (n / B, B * B);
        for bi in 0..blocks {
            for bj in 0..blocks {
                let at = (bi * blocks + bj) * cells;
                if bi == 0 || bj == 0 || bi == blocks - 1 || bj == blocks - 1 {
                    border_block::<B>(n, a, u, v, bi, bj);
                    continue;
                }
                let block = |at: usize| -> &[[f32; B]] { u[at..at + cells].as_chunks::<B>().0 };
                let (middle, left, right) = (block(at), block(at - cells), block(at + cells));
                let (up, down) = (block(at - blocks * cells), block(at + blocks * cells));
                let out = v[at..at + cells].as_chunks_mut::<B>().0;
                row(a, &up[B - 1], &middle[0], &middle[1], &left[0], &right[0], &mut out[0]);
                for i in 1..B - 1 {
                    row(a, &middle[i - 1], &middle[i], &middle[i + 1], &left[i], &right[i], &mut out[i]);
                }
                row(a, &middle[B - 2], &middle[B - 1], &down[0], &left[B - 1], &right[B - 1], &mut out[B - 1]);
            }
        }
    }
}

#[inline(always)]
fn row<const B: usize>(
    a: f32,
    up: &[f32; B],
    row: &[f32; B],
    down: &[f32; B],
    left: &[f32; B],
    right: &[f32; B],
    out: &mut [f32; B],
) {
    // The row moved by one to either side, as whole vectors: shuffles instead of scalar ends.
    let (mut before, mut after) = ([0.0; B], [0.0; B]);
    before[1..].copy_from_slice(&row[..B - 1]);
    before[0] = left[B - 1];
    after[..B - 1].copy_from_slice(&row[1..]);
    after[B - 1] = right[0];
    let mut values = [0.0; B];
    for j in 0..B {
        values[j] = a * (up[j] + down[j] + before[j] + after[j]);
    }
    *out = values;
}

#[cold]
fn border_block<const B: usize>(n: usize, a: f32, u: &[f32], v: &mut [f32], bi: usize, bj: usize) {
    let place = |i: usize, j: usize| ((i / B) * (n / B) + j / B) * B * B + (i % B) * B + j % B;
    for i in (bi * B).max(1)..(bi * B + B).min(n - 1) {
        for j in (bj * B).max(1)..(bj * B + B).min(n - 1) {
            v[place(i, j)] = a * (u[place(i - 1, j)] + u[place(i + 1, j)] + u[place(i, j - 1)] + u[place(i, j + 1)]);
        }
    }
}

versions! {
    /// The 7-point Laplacian over rows of a cube.
    pub fn laplacian_rows(n: usize, p: &[f32], q: &mut [f32]) {
        let row = |i: usize, j: usize| &p[(i * n + j) * n..][..n];
        for i in 1..n - 1 {
            for j in 1..n - 1 {
                let (west, east, south, north, middle) =
                    (row(i - 1, j), row(i + 1, j), row(i, j - 1), row(i, j + 1), row(i, j));
                let out = &mut q[(i * n + j) * n..][..n];
                for k in 1..n - 1 {
                    out[k] = west[k] + east[k] + south[k] + north[k] + middle[k - 1] + middle[k + 1] - 6.0 * middle[k];
                }
            }
        }
    }
}
