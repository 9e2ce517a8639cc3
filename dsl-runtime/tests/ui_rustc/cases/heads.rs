//! Heads are checked by rustc where types decide.
use allotrope::prelude::*;

#[kernel]
fn border(u: &mut Field<f32, _>, width: i32) {
    for p in u.interior(width) { //~ E0308
        u[p] = 1.0;
    }
}

fn main() {}
