//! A node has a size for each of its axes.
use allotrope::prelude::*;

type Grid = layout!(dense(ijk).dense(ijk, (4, 2)).aos);

fn main() {}
