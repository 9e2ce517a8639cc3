//! An iteration's own element belongs to its thread (H4).
use allotrope::prelude::*;

#[kernel]
fn split(u: &mut Field<f32, _>) {
    for p in u {
        std::thread::scope(|scope| {
            scope.spawn(|| u[p] = 1.0); //~ E0277
            u[p] = 2.0;
        });
    }
}

fn main() {}
