//! A node has a size for each of its axes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, (4, 2, 2)).aos);

fn main() {}
