//! The axes of a node are a word, not a string.
use allotrope::prelude::*;

type Grid = layout!(dense("ij").aos);

fn main() {}
