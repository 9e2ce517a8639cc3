//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;

#[kernel]
fn pointed(u: &mut Field<bool, _>, at: *mut i32) {
    for p in u {
        u[p] = at.is_null(); //~ E0277
    }
}

fn main() {}
