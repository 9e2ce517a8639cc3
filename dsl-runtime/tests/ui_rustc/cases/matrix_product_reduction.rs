//! A product of matrices depends on the order of its factors, so that it is no reduction.
use allotrope::prelude::*;

#[kernel]
fn wrong(rotations: &Field<Mat2, _>) -> Mat2 {
    let mut all = Mat2::IDENTITY;
    for p in rotations {
        all *= rotations[p]; //~ E0277
    }
    all
}

fn main() {}
