//! Nodes are a closed list.
use allotrope::prelude::*;

type Grid = layout!(dens(ij).dense(ij, 8).aos);

fn main() {}
