//! Bits are accumulated in integers.
use allotrope::prelude::*;

// Rustc blames the view here, and its label the operator's line.
#[kernel] //~ E0277
fn bits(v: &mut Field<f32, _>, at: &Field<u32, _>) {
    for p in at {
        v[at[p]] |= 1.0;
    }
}

fn main() {}
