//! An index has as many places as its field has axes.
use allotrope::prelude::*;

#[kernel]
fn copy(u: &mut Field<f32, _>, v: &Field<f32, _, Ij>) {
    for p in u {
        u[p] = v[p];
    }
}

fn main() {}
