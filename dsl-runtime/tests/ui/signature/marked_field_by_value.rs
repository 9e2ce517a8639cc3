//! A parameter that is marked as a field is taken by reference, as all fields are.
use allotrope::prelude::*;

type Heat<L> = Field<f32, L, Ij>;

#[kernel]
fn wrong(#[field] u: Heat<Aos>) {}

fn main() {}
