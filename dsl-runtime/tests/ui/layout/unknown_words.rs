//! Nodes and places are a closed list.
use allotrope::prelude::*;

type Misspelt = layout!(dens(ij).dense(ij, 8).aos);
type Swapped = layout!(dense(ij).dense(ij, 8).sao);
type Foreign = layout!(dense(ij).interleaved);
type Named = layout!(AoSoA(16));

fn main() {}
