//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;

#[kernel]
fn functions(u: &mut Field<i32, _>, f: &dyn Fn(i32) -> i32) {
    for p in u {
        u[p] = f(p); //~ E0277
    }
}

fn main() {}
