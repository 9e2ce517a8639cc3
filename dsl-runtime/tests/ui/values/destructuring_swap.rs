//! An element is assigned by itself.
use allotrope::prelude::*;

#[kernel]
fn swap(u: &mut Field<u32, _>, v: &mut Field<u32, _>) {
    for p in u {
        (u[p], v[p]) = (v[p], u[p]);
    }
}

fn main() {}
