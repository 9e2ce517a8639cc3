//! Only the outermost node takes its size from the shape.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij).aos);

fn main() {}
