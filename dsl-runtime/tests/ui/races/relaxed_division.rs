//! A division is no one step, though the loop is relaxed.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, u: &mut Field<f32, _>) {
    #[relaxed]
    for p in keys {
        u[keys[p]] /= 2.0;
    }
}

fn main() {}
