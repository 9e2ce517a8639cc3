//! Only a field's layout is left open.
use allotrope::prelude::*;

#[kernel]
fn any(u: &Field<f32, _, _>) {}

fn main() {}
