//! The bits of a block in Z-order are interleaved: each of its sizes is a power of two.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).morton(ij, (4, 6)).soa);

fn main() {}
