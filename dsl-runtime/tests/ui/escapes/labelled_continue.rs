//! No iteration ends a loop around its own.
use allotrope::prelude::*;

#[kernel]
fn search(u: &Field<f32, _>) {
    'steps: loop {
        for p in u {
            for k in 0..3 {
                if u[p] > k as f32 {
                    continue 'steps;
                }
            }
        }
    }
}

fn main() {}
