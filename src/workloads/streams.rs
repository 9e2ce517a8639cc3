//! saxpy and sum.

use allotrope::prelude::*;

/// `y = a x + y`.
#[kernel]
pub fn saxpy(a: f32, x: &Field<f32, _>, y: &mut Field<f32, _>) {
    for i in y {
        y[i] += a * x[i];
    }
}

/// The sum of all values.
#[kernel]
pub fn sum(x: &Field<f32, _>) -> f32 {
    let mut total = 0.0f32;
    for i in x {
        total += x[i];
    }
    total
}
