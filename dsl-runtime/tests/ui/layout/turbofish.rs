//! The sizes of a node stand beside its axes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).dense::<8>(ij).aos);

fn main() {}
