//! No user token stands inside `unsafe` (H9).
use allotrope::prelude::*;

static mut LAST: i32 = 0;

#[kernel]
fn last(u: &mut Field<i32, _>) {
    for p in u {
        LAST = p; //~ E0133
        u[p] = 0;
    }
    LAST = 3; //~ E0133
}

fn main() {}
