//! Old values are taken of integers.
use allotrope::prelude::*;

// Rustc blames the view here, and its label the call's line.
#[kernel] //~ E0277
fn wrong(keys: &Field<u32, _>, sums: &mut Field<f32, _>, old: &mut Field<f32, _>) {
    for p in keys {
        old[p] = sums[keys[p]].fetch_add(1.0);
    }
}

fn main() {}
