//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;
use std::cell::RefCell;

#[kernel]
fn cells(u: &mut Field<i32, _>, seen: &RefCell<Vec<i32>>) {
    for p in u {
        seen.borrow_mut().push(p); //~ E0277
        u[p] = 1;
    }
}

fn main() {}
