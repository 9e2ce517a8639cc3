//! An iteration of a loop in lanes is not left early.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn halve(x: &mut Field<f32, _>, frozen: &Field<bool, _>) {
    for i in x {
        if frozen[i] {
            continue;
        }
        while x[i] > 1.0 {
            x[i] *= 0.5;
        }
    }
}

fn main() {}
