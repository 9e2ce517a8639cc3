//! Padding is said once.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad(64).pad(32).aos);

fn main() {}
