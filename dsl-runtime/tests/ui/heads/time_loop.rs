//! The outermost loop is the parallel one.
use allotrope::prelude::*;

#[kernel]
fn steps(u: &mut Field<f32, _>, v: &mut Field<f32, _>, n: u32) {
    for _t in 0..n {
        for p in v {
            v[p] = 0.5 * u[p];
        }
        for p in u {
            u[p] = v[p];
        }
    }
}

fn main() {}
