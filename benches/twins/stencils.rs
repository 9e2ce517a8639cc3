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
                let rows = |at: usize| -> &[[f32; B]] { u[at..at + cells].as_chunks::<B>().0 };
                let (middle, left, right) = (rows(at), rows(at - cells), rows(at + cells));
                let (up, down) = (rows(at - blocks * cells), rows(at + blocks * cells));
                let mut out = [[0.0; B]; B];
                for i in 0..B {
                    let above = if i == 0 { &up[B - 1] } else { &middle[i - 1] };
                    let below = if i == B - 1 { &down[0] } else { &middle[i + 1] };
                    // The row moved by one to either side: whole vectors from memory, of which one end is another block's.
                    let start = at + i * B;
                    let mut before: [f32; B] = u[start - 1..start - 1 + B].try_into().expect("B values");
                    let mut after: [f32; B] = u[start + 1..start + 1 + B].try_into().expect("B values");
                    before[0] = left[i][B - 1];
                    after[B - 1] = right[i][0];
                    for j in 0..B {
                        out[i][j] = a * (above[j] + below[j] + before[j] + after[j]);
                    }
                }
                v[at..at + cells].as_chunks_mut::<B>().0.copy_from_slice(&out);
            }
        }
    }
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
