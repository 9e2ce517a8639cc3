//! A field's parameter is a name.
use allotrope::prelude::*;

#[kernel]
fn apart(&(ref u): &Field<f32, _>) {}

fn main() {}
