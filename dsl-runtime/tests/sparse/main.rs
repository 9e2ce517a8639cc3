//! Sparse fields: against a map, under threads, in workloads.

mod concurrent;
mod lists;
mod maps;
mod masked;
mod model;
mod stencils;
mod topology;
mod workloads;

/// Numbers that look random and are the same each time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        // SplitMix64.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// One of so many.
    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}
