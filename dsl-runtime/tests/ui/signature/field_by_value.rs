//! A kernel borrows its fields.
use allotrope::prelude::*;

#[kernel]
fn consume(u: Field<f32, _>) {}

fn main() {}
