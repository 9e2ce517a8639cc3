//! Reductions are of numbers, vectors and arrays of a fixed size; a `Vec` is none of them.
use allotrope::prelude::*;

#[kernel] //~ E0599
fn wrong(u: &Field<u32, _>, count: usize) -> Vec<u32> {
    let mut bins = vec![0u32; count];
    for p in u {
        bins[u[p] as usize] += 1; //~ E0277 E0599
    }
    bins
}

fn main() {}
