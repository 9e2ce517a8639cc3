//! The values of a member have a type.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Member<_, _, Ij>) {}

fn main() {}
