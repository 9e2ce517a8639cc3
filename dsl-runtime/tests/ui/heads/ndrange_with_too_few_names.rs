//! A tuple names each range.
use allotrope::prelude::*;

#[kernel]
fn count(bins: &mut Field<u32, _>, n: usize) {
    for (a, b) in ndrange!(0..n, 0..n, 0..n) {
        bins[a * b] += 1;
    }
}

fn main() {}
