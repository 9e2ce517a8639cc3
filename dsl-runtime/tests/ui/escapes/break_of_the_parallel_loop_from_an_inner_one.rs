//! No iteration ends the others.
use allotrope::prelude::*;

#[kernel]
fn search(u: &mut Field<f32, _>) {
    'all: for p in u {
        for k in 0..3 {
            if u[p] > k as f32 {
                break 'all;
            }
        }
    }
}

fn main() {}
