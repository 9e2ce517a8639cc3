//! Lanes are for inner loops that are left at their ends.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn scale(x: &mut Field<f32, _>) {
    for i in x {
        x[i] *= 2.0;
    }
}

#[kernel(lanes = 16)]
fn halve(x: &mut Field<f32, _>) {
    for i in x {
        loop {
            if x[i] < 1.0 {
                break;
            }
            x[i] *= 0.5;
        }
    }
}

fn main() {}
