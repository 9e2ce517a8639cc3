//! Places are a closed list.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).interleaved);

fn main() {}
