//! Accumulators belong to their job (H4).
use allotrope::prelude::*;

#[kernel]
fn split(u: &Field<u32, _>, bins: &mut Field<u32, _>) {
    for p in u {
        std::thread::scope(|scope| {
            scope.spawn(|| bins[u[p]] += 1); //~ E0277
        });
    }
}

fn main() {}
