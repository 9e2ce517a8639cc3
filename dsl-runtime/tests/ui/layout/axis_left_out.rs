//! The axes of a layout begin with `i` and leave none out.
use allotrope::prelude::*;

type Grid = layout!(dense(ik).dense(ik, 4).aos);

fn main() {}
