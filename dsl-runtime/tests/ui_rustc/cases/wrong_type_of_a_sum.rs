//! Values are checked by rustc, at the user's tokens.
use allotrope::prelude::*;

#[kernel]
fn values(u: &mut Field<f32, _>) {
    for p in u {
        u[p] += "one"; //~ E0277
    }
}

fn main() {}
