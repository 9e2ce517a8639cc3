//! What reaches an iteration's own element belongs to its thread (H4).
use allotrope::prelude::*;

#[kernel]
fn split(u: &Field<u32, _>, v: &mut Field<u32, _>) {
    for p in v {
        v[p] = std::thread::scope(|scope| scope.spawn(|| u[p]).join().unwrap_or(0)); //~ E0277
    }
}

fn main() {}
