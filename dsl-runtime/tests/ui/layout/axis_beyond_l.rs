//! There are four axes.
use allotrope::prelude::*;

type Grid = layout!(dense(in_).aos);

fn main() {}
