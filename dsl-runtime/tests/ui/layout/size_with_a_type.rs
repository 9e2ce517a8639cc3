//! Sizes have the type of sizes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, 8u32).aos);

fn main() {}
