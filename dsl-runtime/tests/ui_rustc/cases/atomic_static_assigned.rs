//! Statics are Rust's.
use allotrope::prelude::*;

static COUNT: u32 = 0;

#[kernel]
fn count(u: &mut Field<u32, _>) {
    for p in u {
        COUNT += 1; //~ E0594
        u[p] = COUNT;
    }
}

fn main() {}
