//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;
use std::rc::Rc;

#[kernel]
fn counted(u: &mut Field<i32, _>) {
    let shared = Rc::new(3);
    for p in u {
        u[p] = *shared; //~ E0277
    }
}

fn main() {}
