//! Padding is of the place.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad(64).dense(ij, 8).aos);

fn main() {}
