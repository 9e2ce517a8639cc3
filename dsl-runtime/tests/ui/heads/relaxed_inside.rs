//! `#[relaxed]` is about the iterations of a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _, Ij>, found: &mut Field<i32, _>) {
    for i in 0..8 {
        #[relaxed]
        for j in 0..8 {
            found[keys[(i, j)]] += j;
        }
    }
}

fn main() {}
