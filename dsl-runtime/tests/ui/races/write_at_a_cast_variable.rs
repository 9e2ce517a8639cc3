//! A cast may make two indices one.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>, n: u64) {
    for i in 0..n {
        u[i as i32] = 1.0;
    }
}

fn main() {}
