//! A `move` closure would take the views away.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>) {
    for p in u {
        let plus = move |x: f32| u[p] + x;
        u[p] = plus(1.0);
    }
}

fn main() {}
