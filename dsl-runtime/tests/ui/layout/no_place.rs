//! A place says how records lie in the innermost node.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense(ij, 8));

fn main() {}
