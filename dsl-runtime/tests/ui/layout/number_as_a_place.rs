//! Places have names.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).0);

fn main() {}
