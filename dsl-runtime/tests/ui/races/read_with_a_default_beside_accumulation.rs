//! A read with a boundary rule is a read of any element.
use allotrope::prelude::*;

#[kernel]
fn spread(total: &mut Field<f32, _>, n: usize) {
    for p in 0..n {
        total[0] += total.or(p, 1.0);
    }
}

fn main() {}
