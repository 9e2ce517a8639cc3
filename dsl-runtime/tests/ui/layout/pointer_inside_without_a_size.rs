//! An inner `pointer` without a size.
use allotrope::prelude::*;

type Wrong = layout!(pointer(ij).pointer(ij).dense(ij, 8).aos);

fn main() {}
