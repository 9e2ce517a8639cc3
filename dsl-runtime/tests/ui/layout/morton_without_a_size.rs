//! A block in Z-order has a constant size.
use allotrope::prelude::*;

type Grid = layout!(morton(ij).aos);

fn main() {}
