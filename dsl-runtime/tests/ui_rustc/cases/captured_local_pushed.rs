//! A parallel loop cannot change what it captures (H10).
use allotrope::prelude::*;

#[kernel]
fn local(u: &mut Field<i32, _>) {
    let mut list = Vec::new();
    for p in u {
        list.push(u[p]); //~ E0596
    }
    drop(list);
}

fn main() {}
