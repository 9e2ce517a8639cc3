//! Padding is a number of bytes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad("64").aos);

fn main() {}
