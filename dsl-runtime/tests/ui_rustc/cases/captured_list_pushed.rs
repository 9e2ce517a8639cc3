//! A parallel loop cannot change what it captures (H10).
use allotrope::prelude::*;

#[kernel]
fn push(u: &mut Field<i32, _>, list: &mut Vec<i32>) {
    for p in u {
        list.push(u[p]); //~ E0596
    }
}

fn main() {}
