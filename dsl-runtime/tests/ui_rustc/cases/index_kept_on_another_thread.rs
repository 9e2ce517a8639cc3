//! A closure with an own access does not leave its thread (H4).
use allotrope::prelude::*;

fn elsewhere(f: impl FnOnce() -> f32 + Send) -> f32 {
    f()
}

#[kernel]
fn send(u: &mut Field<f32, _>) {
    for p in u {
        u[p] = 1.0;
        let x = elsewhere(|| u[p]); //~ E0277
        u[p] = x;
    }
}

fn main() {}
