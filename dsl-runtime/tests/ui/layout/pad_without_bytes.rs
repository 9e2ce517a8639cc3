//! Padding is a number of bytes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad.aos);

fn main() {}
