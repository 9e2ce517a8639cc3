//! `unroll!` copies a body for each of some constants.
use allotrope::prelude::*;

const N: i32 = 3;

#[kernel]
fn wrong(u: &mut Field<f32, _>, n: i32) {
    for p in u {
        for i in unroll!(0..N) {
            u[p] += i as f32;
        }
        for i in unroll!(0..n, 0..3) {
            u[p] += i as f32;
        }
        for (i, j) in unroll!(0..3) {
            u[p] += (i + j) as f32;
        }
        let all = unroll!(0..3);
    }
    for i in unroll!(0..3) {
        u[i] = 1.0;
    }
}

fn main() {}
