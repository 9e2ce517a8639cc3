//! An enum has no sum.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
enum Phase {
    Water,
    Ice,
}

#[kernel] //~ E0277
fn accumulate(phases: &mut Field<Phase, _>, at: &Field<i32, _>) {
    for p in at {
        phases[at[p]] += Phase::Ice;
    }
}

fn main() {}
