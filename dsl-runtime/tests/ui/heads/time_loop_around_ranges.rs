//! The outermost loop is the parallel one.
use allotrope::prelude::*;

#[kernel]
fn steps(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>, n: i32) {
    for _t in 0..100 {
        for i in 1..n {
            for j in 1..n {
                v[(i, j)] = u[(i - 1, j)];
            }
        }
    }
}

fn main() {}
