//! The sphere's shell as an expert would keep it: a list of blocks of 8 x 8 x 8 cells, each with the numbers of its six neighbours.

use std::collections::HashMap;

use super::versions;

/// Rows of 8 cells, 8 x 8 of them.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Block([[f32; 8]; 64]);

/// Two values a cell. Block 0 is empty and stands for all that are not there.
pub(crate) struct Shell {
    u: Vec<Block>,
    w: Vec<Block>,
    /// A bit for each cell, a byte for each row.
    active: Vec<[u8; 64]>,
    /// The neighbours below and above along each axis.
    beside: Vec<[u32; 6]>,
    numbers: HashMap<[i32; 3], u32>,
}

impl Shell {
    /// Of the active cells and their values.
    pub(crate) fn new(cells: impl Iterator<Item = ([i32; 3], f32)>) -> Self {
        let empty = Block([[0.0; 8]; 64]);
        let mut this = Self {
            u: vec![empty],
            w: vec![empty],
            active: vec![[0; 64]],
            beside: vec![[0; 6]],
            numbers: HashMap::new(),
        };
        for (at, value) in cells {
            let (block, inner) = (at.map(|c| c.div_euclid(8)), at.map(|c| c.rem_euclid(8) as usize));
            let number = *this.numbers.entry(block).or_insert_with(|| {
                this.u.push(empty);
                this.w.push(empty);
                this.active.push([0; 64]);
                this.u.len() as u32 - 1
            }) as usize;
            let row = inner[0] * 8 + inner[1];
            this.u[number].0[row][inner[2]] = value;
            this.active[number][row] |= 1 << inner[2];
        }
        this.beside.resize(this.u.len(), [0; 6]);
        for (block, &number) in &this.numbers {
            this.beside[number as usize] = std::array::from_fn(|side| {
                let mut at = *block;
                at[side / 2] += if side % 2 == 0 { -1 } else { 1 };
                this.numbers.get(&at).copied().unwrap_or(0)
            });
        }
        this
    }

    /// The Laplacian at an active cell.
    pub(crate) fn laplacian_at(&self, at: [i32; 3]) -> f32 {
        let (block, inner) = (at.map(|c| c.div_euclid(8)), at.map(|c| c.rem_euclid(8) as usize));
        self.w[self.numbers[&block] as usize].0[inner[0] * 8 + inner[1]][inner[2]]
    }

    /// The Laplacian of all active cells.
    pub(crate) fn laplacian(&mut self, cpu: allotrope::Cpu, threads: usize) {
        let Self { u, w, active, beside, .. } = self;
        let part = w.len().div_ceil(threads);
        let parts = w.chunks_mut(part).enumerate();
        in_parallel(parts, |(n, w)| laplacian_of(cpu, n * part, u, w, active, beside));
    }

    /// Scales all active cells.
    pub(crate) fn scale(&mut self, cpu: allotrope::Cpu, threads: usize, by: f32) {
        let part = self.u.len().div_ceil(threads);
        let active = &self.active;
        let parts = self.u.chunks_mut(part).enumerate();
        in_parallel(parts, |(n, u)| scale_of(cpu, &active[n * part..], u, by));
    }
}

/// Runs each part on a thread, the last on this one.
fn in_parallel<T: Send>(mut parts: impl ExactSizeIterator<Item = T>, run: impl Fn(T) + Sync) {
    std::thread::scope(|scope| {
        let run = &run;
        while parts.len() > 1 {
            if let Some(part) = parts.next() {
                scope.spawn(move || run(part));
            }
        }
        parts.for_each(run);
    });
}

/// `new` where a bit is set, else `old`.
#[inline(always)]
fn masked(bits: u8, new: [f32; 8], old: &mut [f32; 8]) {
    for k in 0..8 {
        old[k] = if bits >> k & 1 == 1 { new[k] } else { old[k] };
    }
}

versions! {
    /// Row by row of eight, those without an active cell left out.
    pub fn laplacian_of(first: usize, u: &[Block], w: &mut [Block], active: &[[u8; 64]], beside: &[[u32; 6]]) {
        for (n, out) in w.iter_mut().enumerate() {
            let (middle, sides) = (&u[first + n].0, beside[first + n].map(|side| &u[side as usize].0));
            let bits = &active[first + n];
            for i in 0..8 {
                for j in 0..8 {
                    let at = i * 8 + j;
                    if bits[at] == 0 {
                        continue;
                    }
                    let row = &middle[at];
                    let west = if i == 0 { &sides[0][56 + j] } else { &middle[at - 8] };
                    let east = if i == 7 { &sides[1][j] } else { &middle[at + 8] };
                    let south = if j == 0 { &sides[2][i * 8 + 7] } else { &middle[at - 1] };
                    let north = if j == 7 { &sides[3][i * 8] } else { &middle[at + 1] };
                    let below = [sides[4][at][7], row[0], row[1], row[2], row[3], row[4], row[5], row[6]];
                    let above = [row[1], row[2], row[3], row[4], row[5], row[6], row[7], sides[5][at][0]];
                    let sum = std::array::from_fn(|k| {
                        west[k] + east[k] + south[k] + north[k] + below[k] + above[k] - 6.0 * row[k]
                    });
                    masked(bits[at], sum, &mut out.0[at]);
                }
            }
        }
    }
}

versions! {
    /// Row by row of eight.
    pub fn scale_of(active: &[[u8; 64]], u: &mut [Block], by: f32) {
        for (block, bits) in u.iter_mut().zip(active) {
            for (row, &bits) in block.0.iter_mut().zip(bits) {
                if bits != 0 {
                    masked(bits, row.map(|u| u * by), row);
                }
            }
        }
    }
}
