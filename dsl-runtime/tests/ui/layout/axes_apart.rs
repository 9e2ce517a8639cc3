//! The axes of a node are one word.
use allotrope::prelude::*;

type Grid = layout!(dense(i, j).aos);

fn main() {}
