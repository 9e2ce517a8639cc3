//! No iteration ends the kernel.
use allotrope::prelude::*;

#[kernel]
fn search(u: &mut Field<f32, _>) {
    for p in u {
        loop {
            u[p] += 1.0;
            if u[p] > 9.0 {
                return;
            }
        }
    }
}

fn main() {}
