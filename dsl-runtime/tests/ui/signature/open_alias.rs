//! Which parameter of another name is the layout cannot be seen.
use allotrope::prelude::*;

type Heat<L> = Field<f32, L, Ij>;

#[kernel]
fn wrong(#[field] u: &Heat<_>) {}

fn main() {}
