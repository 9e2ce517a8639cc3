//! A field's parameter is a name.
use allotrope::prelude::*;

#[kernel]
fn ignore(_: &Field<f32, _>) {}

fn main() {}
