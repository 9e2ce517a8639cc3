//! A body is written out once for each value.
#![deny(deprecated)]
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _, Ij>, next: &mut Field<f32, _, Ij>) {
    for (i, j) in next.interior(10) {
        for a in unroll!(-10..11) {
            for b in unroll!(-10..11) {
                next[(i, j)] += u[(i + a, j + b)];
            }
        }
    }
}

fn main() {}
