//! An entry that another iteration is appending could be read.
use allotrope::prelude::*;

#[kernel]
fn wrong(points: &mut Field<f32, _>) {
    for p in points {
        points.append((), points[p / 2]);
    }
}

fn main() {}
