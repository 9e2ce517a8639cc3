//! A macro could bind the loop variable again.
use allotrope::prelude::*;

macro_rules! skip {
    ($name:ident) => {
        let $name = 0;
    };
}

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        skip!(p);
        u[p] = 1.0;
    }
}

fn main() {}
