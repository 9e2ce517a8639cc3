//! Memory is aligned to powers of two.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad(48).aos);

fn main() {}
