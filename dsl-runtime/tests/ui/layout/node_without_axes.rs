//! A node says over which axes it goes.
use allotrope::prelude::*;

type Grid = layout!(dense.aos);

fn main() {}
