//! The bits of a block in Z-order are interleaved: its sizes are powers of two.
use allotrope::prelude::*;

type Grid = layout!(morton(ij, 12).aos);

fn main() {}
