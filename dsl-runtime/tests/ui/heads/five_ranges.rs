//! A loop has four ranges at most.
use allotrope::prelude::*;

#[kernel]
fn count(bins: &mut Field<u32, _>, n: usize) {
    for (a, b, c, d, e) in ndrange!(0..n, 0..n, 0..n, 0..n, 0..n) {
        bins[a + b + c + d + e] += 1;
    }
}

fn main() {}
