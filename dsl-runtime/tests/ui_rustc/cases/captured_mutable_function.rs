//! A parallel loop cannot change what it captures (H10).
use allotrope::prelude::*;

#[kernel]
fn call(u: &mut Field<i32, _>, f: &mut impl FnMut(i32) -> i32) {
    for p in u {
        u[p] = f(p); //~ E0277
    }
}

fn main() {}
