//! What lanes keep has a value from the start.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn halve(x: &mut Field<f32, _>) {
    for i in x {
        let mut rounds;
        rounds = 0;
        while x[i] > 1.0 {
            let half;
            half = 0.5;
            x[i] *= half;
            for _ in 0..2 {
                rounds += 1;
            }
        }
        x[i] += rounds as f32;
    }
}

fn main() {}
