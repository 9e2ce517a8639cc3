//! The body of a loop over the axes of a type parameter stands in a closure.
use allotrope::prelude::*;
use allotrope::spatial::*;

#[kernel]
fn wrong<X: Spatial>(u: &Field<f32, _, X>, next: &mut Field<f32, _, X>) {
    for at in next.interior(1) {
        for offset in unroll!(X, -1..2) {
            if u[at + offset] > 0.0 {
                next[at] = 1.0;
                break;
            }
        }
    }
}

fn main() {}
