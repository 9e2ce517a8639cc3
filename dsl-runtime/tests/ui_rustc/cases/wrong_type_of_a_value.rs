//! Values are checked by rustc, at the user's tokens.
use allotrope::prelude::*;

#[kernel]
fn values(u: &mut Field<f32, _>, v: &Field<i32, _>) {
    for p in u {
        u[p] = v[p]; //~ E0308
    }
}

fn main() {}
