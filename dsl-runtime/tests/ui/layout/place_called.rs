//! A place takes no arguments.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).aos());

fn main() {}
