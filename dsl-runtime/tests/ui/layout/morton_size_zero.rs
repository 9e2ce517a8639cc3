//! A block has cells.
use allotrope::prelude::*;

type Grid = layout!(morton(ij, 0).aos);

fn main() {}
