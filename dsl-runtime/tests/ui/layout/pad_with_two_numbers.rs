//! Padding is one number.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad(64, 64).aos);

fn main() {}
