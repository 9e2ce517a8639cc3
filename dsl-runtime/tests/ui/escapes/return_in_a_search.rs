//! No iteration ends the kernel.
use allotrope::prelude::*;

#[kernel]
fn find(u: &Field<f32, _>) -> Option<i32> {
    for p in u {
        if u[p] > 3.0 {
            return Some(p);
        }
    }
    None
}

fn main() {}
