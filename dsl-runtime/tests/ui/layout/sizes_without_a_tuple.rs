//! Sizes that differ are a tuple.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, 4, 2).aos);

fn main() {}
