//! Loops in lanes change no lists.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn collect(x: &Field<f32, _>, lists: &mut Field<f32, _, Ij>) {
    for i in x {
        let mut value = x[i];
        while value > 1.0 {
            value *= 0.5;
        }
        lists.append(i, value);
    }
}

fn main() {}
