//! A place closes the layout.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).soa.dense(ij, 8));

fn main() {}
