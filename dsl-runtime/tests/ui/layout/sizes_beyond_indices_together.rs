//! Indices are `i32`, and the sizes of nodes that nest multiply.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(i, 65_536).dense(ij, 65_536).aos);

fn main() {}
