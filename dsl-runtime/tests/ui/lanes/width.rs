//! There are five numbers of lanes.
use allotrope::prelude::*;

#[kernel(lanes = 12)]
fn powers(x: &Field<f32, _>, y: &mut Field<f32, _>) {
    for i in y {
        let mut sum = 0.0;
        for power in 0..4 {
            sum += x[i].powi(power);
        }
        y[i] = sum;
    }
}

#[kernel(lanes)]
fn halves(x: &mut Field<f32, _>) {
    for i in x {
        while x[i] > 1.0 {
            x[i] *= 0.5;
        }
    }
}

fn main() {}
