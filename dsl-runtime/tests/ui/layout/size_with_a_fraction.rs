//! Sizes are integers.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, 2.5).aos);

fn main() {}
