//! A parallel loop cannot change what it captures (H10).
use allotrope::prelude::*;

#[kernel]
fn push(u: &mut Field<i32, _>, list: &mut Vec<i32>) {
    for p in u {
        list.push(u[p]); //~ E0596
    }
}

#[kernel]
fn call(u: &mut Field<i32, _>, f: &mut impl FnMut(i32) -> i32) {
    for p in u {
        u[p] = f(p); //~ E0277
    }
}

#[kernel]
fn local(u: &mut Field<i32, _>) {
    let mut list = Vec::new();
    for p in u {
        list.push(u[p]); //~ E0596
    }
    drop(list);
}

fn main() {}
