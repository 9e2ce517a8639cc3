//! Sizes are positive.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, -8).aos);

fn main() {}
