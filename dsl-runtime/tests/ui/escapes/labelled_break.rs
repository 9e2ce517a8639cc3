//! No iteration ends a loop around its own.
use allotrope::prelude::*;

#[kernel]
fn search(u: &Field<f32, _>) {
    'steps: loop {
        for p in u {
            if u[p] > 3.0 {
                break 'steps;
            }
        }
    }
}

fn main() {}
