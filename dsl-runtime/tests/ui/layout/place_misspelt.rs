//! Places are a closed list.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, 8).sao);

fn main() {}
