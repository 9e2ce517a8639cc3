//! Values are checked by rustc, at the user's tokens.
use allotrope::prelude::*;

#[kernel]
fn values(u: &mut Field<f32, _>) {
    u[0] = true; //~ E0308
}

fn main() {}
