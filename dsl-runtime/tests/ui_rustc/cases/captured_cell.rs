//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;
use std::cell::Cell;

#[kernel]
fn cells(u: &mut Field<i32, _>, count: &Cell<i32>) {
    for p in u {
        count.set(count.get() + 1); //~ E0277
        u[p] = 1;
    }
}

fn main() {}
