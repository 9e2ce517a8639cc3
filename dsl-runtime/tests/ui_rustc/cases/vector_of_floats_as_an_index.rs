//! Indices are integers.
use allotrope::prelude::*;

#[kernel]
fn scatter(u: &Field<f32, _>, at: &Field<Vec2, _>, v: &mut Field<f32, _, Ij>) {
    for p in u {
        v[at[p]] += u[p]; //~ E0277
    }
}

fn main() {}
