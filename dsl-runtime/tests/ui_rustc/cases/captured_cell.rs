//! What threads cannot share does not enter a parallel loop (H10).
use allotrope::prelude::*;
use std::cell::Cell;
use std::rc::Rc;

#[kernel]
fn cells(u: &mut Field<i32, _>, count: &Cell<i32>) {
    for p in u {
        count.set(count.get() + 1); //~ E0277
        u[p] = 1;
    }
}

#[kernel]
fn counted(u: &mut Field<i32, _>) {
    let shared = Rc::new(3);
    for p in u {
        u[p] = *shared; //~ E0277
    }
}

#[kernel]
fn functions(u: &mut Field<i32, _>, f: &dyn Fn(i32) -> i32) {
    for p in u {
        u[p] = f(p); //~ E0277
    }
}

#[kernel]
fn on_one_thread(u: &mut Field<i32, _>, count: &Cell<i32>) {
    #[serial]
    for p in u {
        count.set(count.get() + 1);
        u[p] = 1;
    }
}

fn main() {}
