//! No iteration ends the others.
use allotrope::prelude::*;

#[kernel]
fn find(u: &Field<f32, _>) -> i32 {
    let mut found = -1;
    for p in u {
        if u[p] > 3.0 {
            found.max_assign(p);
            break;
        }
    }
    found
}

fn main() {}
