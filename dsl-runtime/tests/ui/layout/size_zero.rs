//! A block has cells.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, (4, 0)).aos);

fn main() {}
